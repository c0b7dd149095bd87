#pragma once
// SPDX-License-Identifier: MIT
// The pass of docs/semantics.md, section 4.4, is greedy along the order of edges: the first candidate takes what it
// needs, and no later one can change that. So one sweep decides, and only the rule that equals never take from each
// other can require another. Cost: some work for each edge of root and for each edge of a group that is opened; for
// each unit decided, the providers and plans tried, each compared along its chain of holders.
//
// A pass notes what its result may depend on besides requests, values and flags: on the assignment before (then it is
// repeated on its own result), and on which groups are stale (then it is repeated when that changes).

#include "runtime/core/arbitration/context.hpp"

namespace director::arbitration {

/// Decides a component from the decision state; writes its `now`, `next_order`, `next_count` and `queued`.
void decide(Context& x, Index component);

/// Begins a pass, or begins it again after a sweep with denials in vain.
void begin(Context& x);

/// Opens all groups, with none of their marks but `kept`, and undoes a sweep over them.
void open_all(Context& x, std::uint8_t kept);

/// Notes for the next pass what this one found, after the engine has compared the result with the last one.
void end(Context& x);

DIRECTOR_PART void keep_unclaimed(Context& x); // limbo.cpp

/// Makes the next pass over each component begin from nothing: the last assignment is not that of its last pass.
void forget_trail(Context& x);

// The walk along the order: walk.cpp, unit.cpp, optional.cpp.

void sweep(Context& x);
void sweep_below(Context& x, Index group);
void walk(Context& x);
void walk_from(Context& x, Index edge);
void walk_from_root(Context& x, Index edge);
DIRECTOR_PART void add_candidates(Context& x, Index group);
DIRECTOR_PART void try_unit(Context& x, Index edge, bool below_stale);
DIRECTOR_PART void postpone(Context& x, Index edge);
DIRECTOR_PART void sweep_optional(Context& x, Index root);

/// Puts a group at this place of the new order.
inline void put(Context& x, Index group, Index at) {
  if (at < x.first_moved && (at >= x.s.order_count[x.component] || x.s.order[x.row.order + at] != group))
    x.first_moved = at;
  x.s.next_order[x.row.order + at] = group;
  x.s.place[group] = at;
}

} // namespace director::arbitration
