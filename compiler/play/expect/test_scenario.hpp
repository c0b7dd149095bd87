#pragma once
// SPDX-License-Identifier: MIT
// Compares the lines of `expect` with what happens, step by step.

#include "compiler/base/json.hpp"
#include "compiler/play/play.hpp"
#include "dsl/source/source_file.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

/// A step that did not happen as expected.
struct Mismatch {
  std::uint32_t step = 1;                           ///< counts from 1
  bool exhausted = false;                           ///< the budget ran out in it
  bool too_many_stops = false;                      ///< ... that of stops, and not of micro-steps
  std::vector<std::string> shown;                   ///< the text of the step
  Span span{};                                      ///< of its `expect`, or of the step if it has none
  std::optional<std::vector<std::string>> expected; ///< empty: it has no `expect`
  std::vector<std::string> happened;
};

struct ScenarioResult {
  std::vector<Mismatch> mismatches;
  Played played;
  std::vector<std::vector<std::string>> happened; ///< in each step that was played
  std::uint32_t compared = 0;                     ///< steps that expect something
  bool holds() const { return mismatches.empty() && !played.refused; }
};

/// Decisions are not compared, even if they are requested.
ScenarioResult test_scenario(const Scenario& scenario, const Model& model, const Lowered& lowered,
                             PlayOptions options = {});

/// For each mismatch its place, its inputs and a diff; a refused action is printed by the caller. Empty if there is no
/// mismatch.
std::string render(const ScenarioResult& result, const dsl::Sources& sources, bool has_colours = false);

/// Likewise, for programs. `title` may be empty.
Json to_json(const ScenarioResult& result, const std::string& file, const std::string& title,
             const dsl::Sources& sources);

} // namespace director::compiler
