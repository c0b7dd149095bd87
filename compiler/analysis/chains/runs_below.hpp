#pragma once
// SPDX-License-Identifier: MIT
// Finds the groups that may run because of a task: itself, and those to which it leads by requests alone. A group that
// is only needed is held, but does not run, and requests nothing (semantics.md, section 5).

#include "compiler/analysis/chains/claims.hpp"

#include <map>
#include <vector>

namespace director::analysis {

class RunsBelow {
public:
  /// `claims`: those of the task by these branches.
  RunsBelow(const Branches& branches, const Claims& claims, GroupId task);

  bool contains(GroupId group) const { return last_.count(group) != 0; }
  /// In order.
  std::vector<GroupId> groups() const;
  /// A shortest path; empty for the task itself.
  std::vector<ChainStep> path(GroupId group) const;

private:
  std::map<GroupId, ChainStep> last_; ///< of that path; the task's own is never read
  GroupId task_;
};

} // namespace director::analysis
