// docs/semantics.md, 4.1, rule 3: what is optional waits in a heap until all else was tried.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/order.hpp"
#include "runtime/core/arbitration/walk.hpp"
#include "runtime/core/base/parts.hpp"

namespace director::part {
const char optional = 0;
}

namespace director::arbitration {

namespace {

inline Index& heap_at(Context& x, Index at) { return x.s.candidate[x.t.edges.size() - 1 - at]; }

Index first_of_heap(Context& x) {
  const Index first = heap_at(x, 0), moved = heap_at(x, --x.postponed);
  Index at = 0;
  for (;;) {
    auto child = static_cast<Index>(2 * at + 1);
    if (child >= x.postponed) break;
    const auto other = static_cast<Index>(child + 1);
    if (other < x.postponed && goes_first(x, heap_at(x, other), heap_at(x, child))) child = other;
    if (goes_first(x, moved, heap_at(x, child))) break;
    heap_at(x, at) = heap_at(x, child);
    at = child;
  }
  if (x.postponed != 0) heap_at(x, at) = moved;
  return first;
}

} // namespace

void postpone(Context& x, Index edge) {
  Index at = x.postponed++;
  while (at > 0) {
    const auto parent = static_cast<Index>((at - 1) / 2);
    if (!goes_first(x, edge, heap_at(x, parent))) break;
    heap_at(x, at) = heap_at(x, parent);
    at = parent;
  }
  heap_at(x, at) = edge;
}

void sweep_optional(Context& x, Index root) {
  for (;;) {
    while (root != nil && x.s.request[root].level == nil) root = x.s.next_root[root];
    const bool waits = x.postponed != 0;
    if (root == nil && !waits) return;
    if (root != nil && (!waits || goes_first(x, root, heap_at(x, 0)))) {
      visit_root(x, root);
      root = x.s.next_root[root];
    } else {
      const Index edge = first_of_heap(x);
      visit(x, edge, x.s.edge_marks[edge]);
    }
    walk_on(x);
  }
}

} // namespace director::arbitration
