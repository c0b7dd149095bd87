#pragma once
// SPDX-License-Identifier: MIT
// What may keep a task from what it would surely take.

#include "compiler/analysis/conflicts/takers.hpp"

#include <set>

namespace director::analysis {

/// Two entries of one pack: `by` takes something that `over`, or what is below that, wants too.
struct Beside {
  GroupId requester{};
  const Unit* unit = nullptr; ///< in which `by` is granted
  const Task* by = nullptr;
  const Task* over = nullptr;
  bool is_before_below =
      false; ///< `by` is granted before anything below `over` is tried, though not before that itself
};

/// Those that may hold something when `by` is tried. What surely goes after it is not asked; below `over` that is
/// everything, or at least what is optional.
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
  std::set<GroupId> after_; ///< other tasks of the requester that surely go after `by`, wherever they are asked for
  std::set<GroupId> early_; ///< what the requester needs, with all that this needs: held before what it requests
  Groups inside_;           ///< what is below the unit, below those and below `over`, and below nothing else
  bool goes_before_over_ = false, is_before_below_ = false;
};

} // namespace director::analysis
