#pragma once
// SPDX-License-Identifier: MIT
// ScenarioSpec -> Scenario: names are looked up, values numbered, scripts laid out per provider. What a script must not
// do is found here as far as it can be: before anything runs.

#include "compiler/play/scenario.hpp"

namespace director::compiler {

struct ResolvedScenario {
  Scenario scenario;
  std::vector<dsl::Diagnostic> findings; ///< all of them, sorted by place; with an error among them nothing is played
};

ResolvedScenario resolve_scenario(const dsl::ScenarioSpec& spec, const Model& model);

} // namespace director::compiler
