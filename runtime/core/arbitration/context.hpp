#pragma once
// SPDX-License-Identifier: MIT
// The argument of every rule of arbitration: the tables, the memory, and the current pass over one component. Each rule
// is a few functions over a Context, in a file with its name.

#include "runtime/core/base/marks.hpp"
#include "runtime/core/base/parts.hpp"

namespace director::arbitration {

/// The requests for a group that the last pass blocked because an earlier edge had claimed it, and that may have
/// another holder now. They stay blocked unless the group is free when the walk reaches them.
struct WaitingLine {
  Index group;
  Index first; ///< the place in the last order of the first requester in line that was not reached; nil: there is none
  bool moves;  ///< one of them was reached, so the others have to be decided again
};

struct Context {
  Context(const Tables& tables, const State& memory) : s(memory), t(tables) {}

  State s; // first, because it is used most: a short offset takes less code
  const Tables t;

  // What remains from pass to pass.
  Index most_decided_whole = director::most_decided_whole;
  Index before_count = 0; ///< rows of State::before in use
  std::uint64_t work = 0; ///< units of work done so far, as docs/bounds.md counts them

  // The current pass.
  Component row;          ///< of the component
  Index component = 0;    ///< its row
  bool whole = false;     ///< all units are decided
  bool settled = false;   ///< no unit has to be decided: the last result remains
  bool had_limbo = false; ///< a group was in limbo in the last assignment; known only if the pass is followed
  bool walking = false;   ///< the walk along the order is not finished
  bool disturbed = false; ///< something differs from the last pass, or may
  mutable bool depends_on_last = false; ///< the result may differ if it is the last assignment itself
  bool on_last = false;                 ///< the same for the units before the current one
  bool depends_on_stale = false;        ///< the current unit may be decided otherwise when other groups are stale
  bool depends_on_requester = false;    ///< or when its own requester is stale no longer
  bool depends_on_all_stale = false;    ///< the result depends also on groups without RunQueueEntry::stale_matters

  Index pushed_count = 0; ///< rows of State::pushed in use: groups with a push in the last assignment or in this one

  // The walk along the order.
  Index ahead = 0;         ///< candidates on its stack, State::candidate
  Index postponed = 0;     ///< optional ones, at the other end of State::candidate
  Index placed = 0;        ///< groups placed so far, the length of the new order
  Index inherited = 0;     ///< those of them that were held in the last assignment
  Index top = nil;         ///< the group that was placed last, or one above it
  Index first_moved = nil; ///< the first place of the order with another group than before
  Index limbo_begin = 0;   ///< from this place on, the groups of the order are in limbo or below such a group
  Index denied_count = 0;  ///< rows of State::denied in use
  Index stale_granted = 0; ///< granted groups that are marked as stale

  // The trail.
  Index opened_count = 0;   ///< rows of State::opened in use
  Index reached_count = 0;  ///< rows of State::reached in use
  Index unopened_count = 0; ///< rows of State::news that were not opened when the pass began: stale groups
  std::array<WaitingLine, 4> waiting_lines{};
  Index line_count = 0;  ///< lines in use
  Index opened_end = 0;  ///< the place in the last order behind all groups that were opened
  Index rest = nil;      ///< the first edge of root, in order, that the walk did not reach; nil: there is none
  Index undecided = nil; ///< an edge of root that has to be decided; until then copy_unchanged_rest() is not called
};

} // namespace director::arbitration
