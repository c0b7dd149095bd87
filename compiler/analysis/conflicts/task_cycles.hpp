#pragma once
// SPDX-License-Identifier: MIT
// Requests that lead back to the group that they come from. A group runs once, so one of them is never granted.

#include "compiler/analysis/input.hpp"

#include <vector>

namespace director::analysis {

struct TaskCycle {
  std::vector<GroupId> groups; ///< each requests the next one; the last one is the first
  /// All that leads to the circle comes in by its first group: then its last request is the one that is never granted.
  /// Else that depends on where it came in.
  bool is_known = true;

  GroupId last_requester() const { return groups[groups.size() - 2]; }
};

/// Of each part of the behaviour in which mandatory requests lead back one of the shortest ones, then each group that
/// requests itself, optional or not.
std::vector<TaskCycle> find_task_cycles(const Model& model, const Shared& shared);

} // namespace director::analysis
