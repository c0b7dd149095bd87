#pragma once
// SPDX-License-Identifier: MIT
// Plays for the matrix: a group is brought to run, and another one is requested beside it.

#include "compiler/transitions/matrix.hpp"
#include "compiler/transitions/trial.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::compiler::transitions {

/// How a group is brought to run.
struct Beginning {
  Way way;
  Outside outside;
  Runs runs;
  Rest rest;
  bool only_certain = false; ///< as of Until
  Values given{};            ///< likewise

  Until until(const Values& outside = {}) const { return {runs, outside, given, only_certain}; }
};

struct Play {
  Script script;
  std::string steps;
  Trial trial;
};

class Player {
public:
  Player(const Model& model, const Lowered& lowered, const std::string& behaviour);

  /// `from`: the step whose events are kept.
  Play play(Script script, std::string steps, std::uint32_t from, const Way& way) const;

  /// Everything before the column's step.
  std::string beginning(const Way& way, const Outside& outside) const;

  /// What ran for the row's task and no longer runs for it.
  std::vector<GroupId> lost(const Beginning& row, const Rest& rest) const;
  /// What the row's side held for needs, and others took from it.
  std::vector<GroupId> needs_taken(const Beginning& row, const Trial& trial) const;
  /// What ran for the row's task, has stopped since, and runs again, for whichever requester.
  std::vector<GroupId> interrupted(const Beginning& row, const Trial& trial) const;

  /// Whether the values alone end the row's task, or all of these groups stop by them or are lost.
  bool ends_by(const Beginning& row, const Beginning& column, const Values& change,
               const std::vector<GroupId>& all) const;

  /// For all plays: the number of characters read and of groups set up, and a fifth of the work of the engine.
  std::size_t work() const { return work_; }

private:
  /// Whether the values end it where what they let run on `then` answers as on that way.
  bool ends_with(const Beginning& row, const Beginning& column, const Way& then, const Values& change,
                 const std::vector<GroupId>& all) const;

  /// The row's way by the column's provider where they part, if that may request the row's task.
  std::optional<Way> way_on(const Way& row, const Way& column) const;

  /// Whether the row's task, or if that runs on, something that it lost, is still requested but others hold what it
  /// needs.
  bool is_blocked(const Beginning& row, const Rest& rest, const std::vector<GroupId>& all) const;

  const Model& model_;
  const Lowered lowered_; ///< each group has a stop handler: all stops are reported
  std::string head_;
  mutable std::size_t work_ = 0;
};

bool runs(const Rest& rest, const Way& way);
/// Also for another requester: it was running then, and is not requested in vain.
bool runs_at_all(const Rest& rest, const Way& way);

} // namespace director::compiler::transitions
