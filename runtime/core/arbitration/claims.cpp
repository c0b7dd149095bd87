// docs/semantics.md, section 4.1: the chains of holders, by the last pass and so far in the one in hand.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/claims.hpp"

#include "runtime/core/base/marks.hpp"

namespace director::arbitration {

/// The walk has passed something that it is a part of.
bool is_passed(const Context& x, Index group) {
  for (; group != nil && !is_opened(x, group); group = requester_of_holder(x, x.s.last[group])) {
    if ((x.s.group_trail[group] & trail::passed) != 0) return true;
  }
  return false;
}

Chain chain(const Context& x, Place place) {
  Chain out;
  for (; place.edge != nil; place.edge = above(x, place)) {
    ++out.length;
    const Index group = requester(x, place.edge);
    if (group == nil) {
      out.top = place.edge;
    } else if (x.lineage_is_valid && place.along == Chains::current && holder_now(x, group) != nil) {
      out.length = static_cast<Index>(out.length + x.s.lineage[group].depth);
      out.top = place.edge; // some edge that is not limbo: which one does not matter
      break;
    }
  }
  return out;
}

bool in_chain(const Context& x, Index edge, Place of) {
  for (; of.edge != nil; of.edge = above(x, of)) {
    if (of.edge == edge) return true;
  }
  return false;
}

} // namespace director::arbitration
