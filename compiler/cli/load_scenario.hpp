#pragma once
// SPDX-License-Identifier: MIT
// A scenario and the behaviour that it is about, ready to be played.

#include "compiler/cli/load.hpp"
#include "compiler/graph/graph.hpp"
#include "compiler/lower/lowered.hpp"
#include "compiler/play/scenario.hpp"

#include <set>
#include <string>
#include <vector>

namespace director::compiler::cli {

struct LoadedScenario {
  int status = clean;                    ///< not clean: it has been said why, and nothing else is good
  std::vector<dsl::Diagnostic> findings; ///< that have been shown
  dsl::FileId file{};                    ///< its own
  std::string behaviour;                 ///< the path of the behaviour's file
  Model model;
  Graph graph;
  Lowered lowered;
  Scenario scenario;
};

/// `printed`: errors as they were told of scenarios before, which are not told again; null: there were none.
LoadedScenario load_scenario(const std::string& file, dsl::Sources& sources, Console& console,
                             std::set<std::string>* printed = nullptr);

} // namespace director::compiler::cli
