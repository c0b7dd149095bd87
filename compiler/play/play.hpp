#pragma once
// SPDX-License-Identifier: MIT
// Plays a scenario: the engine of a robot on lowered tables, with scripted bodies and listed inputs.

#include "compiler/play/event_converter.hpp"
#include "compiler/play/onlooker.hpp"
#include "compiler/play/scenario/scenario.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

/// Micro-steps each time the engine runs: inputs, or one due time.
inline constexpr std::uint32_t play_budget = 10'000;
/// Limit for the due times in one `advance`: an hour of `every: 4 ms`. The events of each are kept until they are
/// compared, and a wrong unit should not exhaust the memory.
inline constexpr std::uint64_t stops_of_advance = 1'000'000;

struct PlayOptions {
  bool decisions = false;             ///< also queue, push, release, set and unset
  const Onlooker* onlooker = nullptr; ///< null: none; the events are the same
  std::uint64_t most_stops = stops_of_advance;
  std::uint32_t steps = 0;                  ///< play no more than so many; 0: all
  std::optional<Time> until{};              ///< play all that happens until this time, itself included
  Observer events{};                        ///< called for every event of the engine, before `sink`
  std::function<void(const Engine&)> end{}; ///< called with the final state of the engine
};

/// The time after so many steps of the scenario.
Time time_after(const Scenario& scenario, std::size_t steps);

/// Where it ended, if not after its last step.
struct Played {
  std::uint32_t last_step = 0; ///< the last one that was played; counts from 1
  bool budget_exhausted = false;
  bool too_many_stops = false;            ///< ... that of stops, and not of micro-steps
  std::optional<dsl::Diagnostic> refused; ///< the action that a body may not do
  std::vector<std::string> round;         ///< groups that run again and again, if it does not come to rest
  std::string after_done;                 ///< the first of them that runs for subtask_done; empty: none
};

/// `: Walk, Legs run again and again`, and what to do about it; empty if it came to rest.
std::string words_of_round(const Played& played);

/// `sink` gets everything in order: each step's inputs, then what happened.
Played play(const Scenario& scenario, const Model& model, const Lowered& lowered, const PlayOptions& options,
            const Sink& sink);

} // namespace director::compiler
