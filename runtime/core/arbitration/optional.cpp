// docs/semantics.md, section 4.1, rule 3: optional candidates wait, in order, until all others were tried.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/order.hpp"
#include "runtime/core/arbitration/pass.hpp"

const char director::part::optional = 0;

namespace director::arbitration {

namespace {

/// A waiting candidate; the first in order is the last. The stack of the walk is at the other end of the same rows.
inline Index& waiting(Context& x, Index at) { return x.s.candidate[x.t.edges.size() - 1 - at]; }

} // namespace

void postpone(Context& x, Index edge) {
  Index begin = 0, end = x.postponed;
  while (begin != end) {
    const auto middle = static_cast<Index>((begin + end) / 2);
    if (goes_first(x, waiting(x, middle), edge)) {
      end = middle;
    } else {
      begin = static_cast<Index>(middle + 1);
    }
  }
  for (Index at = x.postponed++; at != begin; --at) waiting(x, at) = waiting(x, static_cast<Index>(at - 1));
  waiting(x, begin) = edge;
}

void sweep_optional(Context& x, Index root) {
  for (;;) {
    while (root != nil && x.s.request[root].level == nil) root = x.s.next_root[root];
    const Index first = x.postponed == 0 ? nil : waiting(x, static_cast<Index>(x.postponed - 1));
    if (root == nil && first == nil) return;
    if (root != nil && (first == nil || goes_first(x, root, first))) {
      walk_from_root(x, root);
      root = x.s.next_root[root];
    } else {
      --x.postponed;
      walk_from(x, first);
    }
  }
}

} // namespace director::arbitration
