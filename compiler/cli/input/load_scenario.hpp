#pragma once
// SPDX-License-Identifier: MIT
// Loads a scenario and its behaviour, ready to be played.

#include "compiler/cli/input/load.hpp"
#include "compiler/graph/graph.hpp"
#include "compiler/lower/lowered.hpp"
#include "compiler/play/play.hpp"
#include "compiler/play/scenario/scenario.hpp"

#include <set>
#include <string>
#include <vector>

namespace director::compiler::cli {

struct LoadedScenario {
  int status = clean;                    ///< not clean: the reason was printed, and nothing else is valid
  std::vector<dsl::Diagnostic> findings; ///< that have been printed
  dsl::FileId file{};                    ///< its own
  std::string behaviour;                 ///< the path of the behaviour's file
  Model model;
  Graph graph;
  Lowered lowered;
  Scenario scenario;
};

/// `printed`: errors that were printed for earlier scenarios, and are not printed again; null: there were none.
LoadedScenario load_scenario(const std::string& file, dsl::Sources& sources, Console& console, const CppSource& cpp,
                             std::set<std::string>* printed = nullptr);

/// False, and prints it, if the scenario ends before that step or time.
bool has_moment(const LoadedScenario& loaded, const std::string& file, std::uint32_t step,
                std::optional<std::int64_t> time, Console& console);

/// Plays to the end of that step (0: of the scenario), or to that time, and hands the engine to `end`. Empty, and
/// prints why, if a body violates its declaration, or the scenario ends before because the engine did not come to rest.
/// What ends early in that step itself is printed too, and returned.
std::optional<Played> play_to(const LoadedScenario& loaded, std::uint32_t step, std::optional<Time> time,
                              std::function<void(const Engine&)> end, const dsl::Sources& sources, Console& console);

/// Prints in which step the scenario ended early, because the engine did not come to rest.
void print_early_end(const Played& played, const std::string& file, Console& console);

} // namespace director::compiler::cli
