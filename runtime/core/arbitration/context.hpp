#pragma once
// SPDX-License-Identifier: MIT
// What every rule of arbitration works on: the tables, the memory, and the pass in hand. From requests, state values,
// enabled flags, pending reasons and the last assignment comes a new assignment, over one component of the tables: what
// is decided in one never depends on another. Each rule is a few functions over a Context, in a file named for it.

#include "runtime/core/base/marks.hpp"
#include "runtime/core/base/parts.hpp"
#include "runtime/core/base/state.hpp"

#include <array>

namespace director::arbitration {

/// The requests for a group that were blocked in the last pass because an earlier edge had claimed it, where it may
/// have another holder now. They stay blocked unless the group is free when the walk reaches them.
struct WaitingLine {
  Index group;
  Index first; ///< where, in the last order, the requester of the first one stands that was not reached; nil: no such
  bool moves;  ///< one of them was reached: the others have to be decided again too
};

struct Context {
  Context(const Tables& tables, const State& memory) : s(memory), t(tables) {}

  State s; // what is used most lies first: a short offset takes less code
  const Tables t;

  // What is known from pass to pass.
  Index most_decided_whole = director::most_decided_whole;
  Index flipped_count = 0;     ///< rows of State::flipped in use
  Index rerequested_count = 0; ///< rows of State::rerequested in use
  Index before_count = 0;      ///< rows of State::before in use
  std::uint64_t decided = 0;   ///< units so far, again where a pass is repeated
  std::uint64_t work =
      0; ///< so far: groups placed, units decided, choices and plans tried, also in searches for pushes

  // The pass in hand.
  Component row;          ///< of the component
  Index component = 0;    ///< which one that is
  bool whole = false;     ///< all of it is decided
  bool settled = false;   ///< nothing has to be decided: the last result stands
  bool had_limbo = false; ///< in the last assignment something was in limbo; only known where the pass is followed
  bool walking = false;   ///< the pass is on its way along the order
  bool disturbed = false; ///< something differs from the last pass, or may
  mutable bool depends_on_last = false; ///< the result may be another one when it is the last assignment itself
  bool on_last = false;                 ///< the same, of the units before the one in hand
  bool depends_on_stale = false;        ///< the unit in hand may be decided otherwise when other groups are stale
  bool depends_on_orders = false;       ///< or when its own requester is not stale any more
  bool depends_on_all_stale = false;    ///< the result too, also by groups that RunQueueEntry::counts does not name

  // Pushes.
  bool had_pushes = false; ///< there were pushes in the last assignment
  bool pushing = false;    ///< there are in this one
  Index pushed_count = 0;  ///< rows of State::pushed in use

  // The walk along the order.
  Index ahead = 0;         ///< candidates that lie on its stack, State::candidate
  Index postponed = 0;     ///< optional ones, which lie at the other end of it
  Index placed = 0;        ///< groups that are claimed so far, which is the length of the new order
  Index inherited = 0;     ///< how many of them were held in the last assignment
  Index top = nil;         ///< the group that was placed last, or one above it
  Index first_moved = nil; ///< the first place in the order that another group has than before
  Index limbo_begin = 0;   ///< from this place on the groups of the order are in limbo, or below such a one
  Index denied_count = 0;  ///< rows of State::denied in use
  Index stale_granted = 0; ///< groups that are granted and marked as outdated

  // The trail.
  Index opened_count = 0;  ///< rows of State::opened in use
  Index reached_count = 0; ///< rows of State::reached in use
  Index kept_count = 0;    ///< rows of State::news that were left alone when the pass began
  Index stale_kept = 0;    ///< those of them whose orders are outdated
  std::array<WaitingLine, 4> lines{};
  Index line_count = 0;  ///< of them in use
  Index opened_end = 0;  ///< behind what was opened, in the last order
  Index rest = nil;      ///< the first edge of root, in order, that the walk did not reach; nil: it reached all
  Index undecided = nil; ///< an edge of root that has to be decided; until it was, rest_stands() is not asked
};

} // namespace director::arbitration
