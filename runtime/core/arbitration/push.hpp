#pragma once
// SPDX-License-Identifier: MIT
// Pushes, from the one that is made to the one that is dropped. docs/semantics.md, sections 4.3 and 4.4.

#include "runtime/core/arbitration/context.hpp"
#include "runtime/core/arbitration/order.hpp"
#include "runtime/core/base/fault_injection.hpp"

namespace director::arbitration {

void keep_own_pushes(Context& x, Index count);
void list_push(Context& x, Index group);
void keep_pushes(Context& x, Index count);
void push_for(Context& x, Index count, Index unmet);
void finish_pushes(Context& x);
void mark_pushers(Context& x);
void reach_pushes_of(Context& x, Index edge);
void keep_pushes_of_plain(Context& x, Index edge, Index provider);

inline std::span<const Index> pushed_groups(const Context& x) { return {x.s.pushed + x.row.order, x.pushed_count}; }

/// The pusher goes before `edge`, and `edge` is not below it.
inline bool applies(const Context& x, const Push& push, Index edge) {
  return push.edge != nil && before(x, {push.edge, Chains::current}, {edge, Chains::current}) &&
         !in_chain(x, push.edge, {edge, Chains::current});
}

/// The provider that a push moves to the front for an edge that controls the group, or nil.
inline Index pushed_first(const Context& x, Index group, Index edge) {
  const Push& push = x.s.now[group].push;
  if (injected(Fault::pushes_move_nothing)) return nil;
  return push.edge != nil && applies(x, push, edge) ? push.provider : nil;
}

} // namespace director::arbitration
