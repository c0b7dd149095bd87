#pragma once
// SPDX-License-Identifier: MIT
// Finds what may withhold from a task what it would certainly take.

#include "compiler/analysis/conflicts/takers.hpp"

#include <set>

namespace director::analysis {

/// Two entries of one pack: `by` takes something that `over`, or a task below it, also wants.
struct Beside {
  GroupId requester{};
  const Unit* unit = nullptr; ///< in which `by` is granted
  const Task* by = nullptr;
  const Task* over = nullptr;
  bool is_before_below = false; ///< `by` is granted before anything below `over` is tried, but not before `over` itself
};

/// The tasks that may hold something when `by` is tried. Those that certainly go after it do not count: everything
/// below `over`, or at least what is optional there.
class Spoilers {
public:
  Spoilers(const Input& input, const Takers& takers, const Beside& beside);

  /// Of these groups, which `by` takes, those that others may hold.
  Groups of(const Groups& taken) const;

private:
  void find_after(const Beside& beside);
  void find_inside();
  void find_early();
  bool may_hold(const Edge& edge) const;
  bool is_branch(GroupId group) const { return own_.count(group) != 0 || after_.count(group) != 0 || group == over_; }

  const Input& input_;
  const Takers& takers_;
  GroupId requester_, by_, over_;
  std::set<GroupId> own_;   ///< of the unit
  std::set<GroupId> after_; ///< other tasks of the requester that certainly go after `by` in each of its packs
  std::set<GroupId> early_; ///< the requester's needs, and theirs: held before what it requests
  Groups inside_;           ///< what is below the unit, below those and below `over`, and below nothing else
  bool goes_before_over_ = false, is_before_below_ = false;
};

} // namespace director::analysis
