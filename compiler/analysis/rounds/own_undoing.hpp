#pragma once
// SPDX-License-Identifier: MIT
// Finds conditions that a task makes false by what it or a group below it sets, so that it is cut off.

#include "compiler/analysis/causing/root_causers.hpp"
#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/input.hpp"
#include "compiler/analysis/rounds/own_setters.hpp"

#include <optional>
#include <vector>

namespace director::analysis {

struct OwnUndoing {
  Want want;
  Setter by;
  ConditionUse entry{};        ///< what it sets
  ValueSet values;             ///< of these, those with which the waiter cannot continue
  std::vector<ChainStep> path; ///< from the task to the setter's group; empty: the task sets it

  GroupId waits{};              ///< the task that waits for the condition
  GroupId task{};               ///< the task that sets it: the same, or one that is granted together with it
  const Task* member = nullptr; ///< that other one, in the unit

  /// What may make the condition true again.
  enum class Back {
    push, ///< the causer, which the task pushes
    root, ///< the causer, which it cannot push
    stop  ///< the stop of the setter's group
  };
  Back back = Back::push;
  ProviderId causer{};
  const Task* root = nullptr;    ///< of the causer, which goes before the task
  std::optional<dsl::Note> stop; ///< that sets it
  Timing timing = Timing::later;
};

std::vector<OwnUndoing> find_own_undoing(const Input& input);

} // namespace director::analysis
