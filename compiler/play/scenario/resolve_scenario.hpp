#pragma once
// SPDX-License-Identifier: MIT
// ScenarioSpec -> Scenario: names are resolved, values numbered, scripts assigned to providers. What a script must not
// do is reported here, before anything runs, as far as possible.

#include "compiler/play/scenario/scenario.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

struct ResolvedScenario {
  Scenario scenario;
  std::vector<dsl::Diagnostic> findings; ///< all of them, sorted by place; with an error among them nothing is played
};

ResolvedScenario resolve_scenario(const dsl::ScenarioSpec& spec, const Model& model);

/// Of a text that the compiler wrote itself; empty: the text has errors.
std::optional<Scenario> scenario_from(const std::string& text, const Model& model);

} // namespace director::compiler
