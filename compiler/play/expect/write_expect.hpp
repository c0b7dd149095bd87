#pragma once
// SPDX-License-Identifier: MIT
// Writes what happened into a scenario: `directorc test --update`.

#include "compiler/play/expect/test_scenario.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace director::compiler {

struct Updated {
  std::string text;
  std::vector<std::uint32_t> steps; ///< that were written, counted from 1; empty: nothing changed
};

/// The text of the scenario's file with what happened in the `expect` of each step that differed; in a scenario without
/// any `expect`, of each step. A step without an `expect` beside others that have one stays so. Everything else in the
/// text is unchanged. Nothing is written for a scenario that did not reach its end.
Updated write_expect(const std::string& text, const Scenario& scenario, const ScenarioResult& result);

} // namespace director::compiler
