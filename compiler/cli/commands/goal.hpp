#pragma once
// SPDX-License-Identifier: MIT
// Parses the goal of `--explain-reachable`: `Kick`, `Walk.halting`, `Pose == standing`.

#include "compiler/analysis/facts/witness.hpp"

#include <string>

namespace director::compiler::cli {

struct ParsedGoal {
  std::optional<analysis::Goal> goal;
  std::string wrong; ///< why there is none
};

ParsedGoal parse_goal(const Model& model, const std::string& words);

} // namespace director::compiler::cli
