#pragma once
// SPDX-License-Identifier: MIT
// Pushes: made, kept, applied and dropped. docs/semantics.md, sections 4.3 and 4.4.

#include "runtime/core/arbitration/order.hpp"

namespace director::arbitration {

DIRECTOR_PART void keep_own_pushes(Context& x, Index count);
DIRECTOR_PART void keep_last_pushes(Context& x, Index count);
DIRECTOR_PART void list_push(Context& x, Index group);
DIRECTOR_PART bool finds_no_push(Context& x, Index edge);
DIRECTOR_PART void push_for(Context& x, Index count, Index unmet);
DIRECTOR_PART void finish_pushes(Context& x);
DIRECTOR_PART void mark_pushers(Context& x);
DIRECTOR_PART void reach_pushes(Context& x, Index edge);
DIRECTOR_PART void withdraw_pushes(Context& x, Index edge);
DIRECTOR_PART Push push_so_far(const Context& x, Index group);
DIRECTOR_PART Index preferred_by_push(const Context& x, Index group, Index place, Index edge);

/// Keeps the pushes that the unit made before.
inline void keep_pushes(Context& x, Index count) {
  if (x.pushed_count != 0) keep_last_pushes(x, count);
}

/// Reaches the groups that this edge pushes.
inline void reach_pushes_of(Context& x, Index edge) {
  if (x.s.edge_marks[edge].has(mark::pushes)) reach_pushes(x, edge);
}

/// The provider at a place in the order of preference for `edge`.
inline Index preferred(const Context& x, Index group, Index place, Index edge) {
  return x.s.now[group].push.edge == nil ? static_cast<Index>(x.t.groups[group].providers.begin + place)
                                         : preferred_by_push(x, group, place, edge);
}

inline std::span<const Index> pushed_groups(const Context& x) { return {x.s.pushed + x.row.order, x.pushed_count}; }

/// Whether the push applies to `edge`: its edge goes before `edge`, which is not below it.
DIRECTOR_ONE_COPY inline bool applies(const Context& x, const Push& push, Index edge) {
  return push.edge != nil && before(x, {push.edge, Chains::current}, {edge, Chains::current}) &&
         !in_chain(x, push.edge, {edge, Chains::current});
}

} // namespace director::arbitration
