#pragma once
// SPDX-License-Identifier: MIT
// Finds the groups because of which not all members of a unit can be granted.

#include "runtime/core/inspect/view.hpp"

#include <map>
#include <vector>

namespace director {

class UnitContests {
public:
  /// The view must outlive this.
  explicit UnitContests(const View& view) : v_(view), t_(*view.tables) {}

  /// The groups that more than one of the edges has to take, without those that are only needed by another one of them.
  std::vector<Index> contested_by(const std::vector<Index>& edges);
  /// Whether the group is the other one, or each enabled provider of it needs that, directly or not.
  bool cannot_do_without(Index group, Index other);

private:
  const std::vector<Index>& indispensable(Index group_row);

  const View& v_;
  const Tables& t_;
  std::map<Index, std::vector<Index>> indispensable_; ///< by group
};

} // namespace director
