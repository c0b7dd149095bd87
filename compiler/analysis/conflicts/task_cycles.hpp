#pragma once
// SPDX-License-Identifier: MIT
// Finds requests that lead back to the group that they come from. A group runs once, so one of them is never granted.

#include "compiler/analysis/input.hpp"

#include <vector>

namespace director::analysis {

struct TaskCycle {
  std::vector<GroupId> groups; ///< each requests the next one; the last one is the first
  /// Whether everything that leads to the cycle enters it at its first group: then its last request is the one that is
  /// never granted. Otherwise that depends on where it is entered.
  bool is_known = true;

  GroupId last_requester() const { return groups[groups.size() - 2]; }
};

/// For each part of the behaviour in which mandatory requests form a cycle one of the shortest ones, then each group
/// that requests itself, optional or not.
std::vector<TaskCycle> find_task_cycles(const Model& model, const Shared& shared);

} // namespace director::analysis
