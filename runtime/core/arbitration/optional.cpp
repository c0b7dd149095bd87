// docs/semantics.md, section 4.1, rule 3: optional candidates wait, in order, until all others were tried.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/order.hpp"
#include "runtime/core/arbitration/pass.hpp"

#include <utility>

const char director::part::optional = 0;

namespace director::arbitration {

namespace {

/// A waiting candidate; the first in order is the last. The stack of the walk is at the other end of the same rows.
inline Index& waiting(Context& x, Index at) { return x.s.candidate[x.t.edges.size() - 1 - at]; }

/// Reverses the candidates from this one on, which the walk has postponed in order. They come before all others: no
/// candidate that waited before is below the edge where that walk began.
void put_first(Context& x, Index from) {
  for (Index end = x.postponed; from + 1 < end;) std::swap(waiting(x, from++), waiting(x, --end));
}

} // namespace

/// Two optional edges are ordered by the siblings above them, as the walk visits these.
void postpone(Context& x, Index edge) {
  x.s.edge_marks[edge].remove(mark::optional);
  waiting(x, x.postponed++) = edge;
}

void sweep_optional(Context& x, Index root) {
  put_first(x, 0);
  for (;;) {
    while (root != nil && x.s.request[root].level == nil) root = x.s.next_root[root];
    const Index first = x.postponed == 0 ? nil : waiting(x, static_cast<Index>(x.postponed - 1));
    if (root == nil && first == nil) return;
    if (root != nil && (first == nil || compare(x, {root, Chains::current}, {first, Chains::current}, true) < 0)) {
      const Index from = x.postponed;
      walk_from_root(x, root);
      put_first(x, from);
      root = x.s.next_root[root];
    } else {
      const Index from = --x.postponed;
      walk_from(x, first);
      put_first(x, from);
    }
  }
}

} // namespace director::arbitration
