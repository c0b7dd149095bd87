#pragma once
// SPDX-License-Identifier: MIT
// Tries candidates in order. docs/semantics.md, section 4.4.

#include "runtime/core/arbitration/context.hpp"
#include "runtime/core/base/parts.hpp"

namespace director::arbitration {

void sweep(Context& x);
void sweep_below(Context& x, Index group);
void visit(Context& x, Index edge, std::uint8_t marks);
void visit_root(Context& x, Index edge);
void walk_on(Context& x);
DIRECTOR_PART void add_candidates(Context& x, Index group);
DIRECTOR_PART void postpone(Context& x, Index edge);
DIRECTOR_PART void sweep_optional(Context& x, Index root);
DIRECTOR_PART void pass_by(Context& x, Index group);
DIRECTOR_PART void close_extents(Context& x, Index group);

/// Puts a group at this place of the new order.
inline void put(Context& x, Index group, Index at) {
  if (at < x.first_moved && (at >= x.s.order_count[x.component] || x.s.order[x.row.order + at] != group))
    x.first_moved = at;
  x.s.next_order[x.row.order + at] = group;
  x.s.place[group] = at;
}

} // namespace director::arbitration
