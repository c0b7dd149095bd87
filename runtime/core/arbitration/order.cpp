// Door: runtime/core/arbitration/order.hpp. Test: tests/runtime/core/arbitration/arbitration_test.cpp.
// SPDX-License-Identifier: MIT
//
// Section 4.1: the order between two edges. Along both chains from the bottom up at equal height, the pair of different
// edges nearest to root is where they part: all below it belongs to one side only. One walk finds that pair and whether
// something optional lies on either side. Cost: the length of the longer chain.

#include "runtime/core/arbitration/order.hpp"

#include "runtime/core/base/heap_sort.hpp"
#include "runtime/core/base/fault_injection.hpp"

namespace director {

/// The walk has passed something that it is a part of.
bool Order::is_passed(Index group) const {
  for (; group != nil && !is_opened(group); group = requester_of_holder(s_.last[group])) {
    if ((s_.group_trail[group] & trail::passed) != 0) return true;
  }
  return false;
}

Order::Chain Order::chain(Place place) const {
  Chain out;
  for (; place.edge != nil; place.edge = above(place)) {
    ++out.length;
    const Index group = requester(place.edge);
    if (group == nil) {
      out.top = place.edge;
    } else if (lineage_is_valid_ && place.along == Chains::current && holder_now(group) != nil) {
      out.length = static_cast<Index>(out.length + s_.lineage[group].depth);
      out.top = place.edge; // some edge that is not limbo: which one does not matter
      break;
    }
  }
  return out;
}

bool Order::in_chain(Index edge, Place of) const {
  for (; of.edge != nil; of.edge = above(of)) {
    if (of.edge == edge) return true;
  }
  return false;
}

/// Two edges whose chains end with the same edge of root: their depths are known, and chains that have met stay
/// together.
int Order::compare_relatives(Index a, Index b, bool in_order) const {
  const Edge* const edges = t_.edges.data();
  const GroupAssignment* const now = s_.now.group;
  Index from_a = edges[a].requester, from_b = edges[b].requester;
  Index depth_a = from_a == nil ? Index{0} : s_.lineage[from_a].depth,
        depth_b = from_b == nil ? Index{0} : s_.lineage[from_b].depth;
  bool optional_a = optional(a), optional_b = optional(b);
  const auto climb = [&](Index& edge, Index& from, bool& is_optional) {
    edge = now[from].holder;
    from = edges[edge].requester;
    is_optional = is_optional || optional(edge);
  };
  const Index lower_a = depth_a, lower_b = depth_b;
  for (; depth_a > depth_b; --depth_a) climb(a, from_a, optional_a);
  for (; depth_b > depth_a; --depth_b) climb(b, from_b, optional_b);
  if (a == b && injected(Fault::ancestors_are_equals)) return 0;
  if (a == b) return lower_a < lower_b ? -1 : lower_a > lower_b ? 1 : 0; // rule 1
  while (from_a != from_b) {
    climb(a, from_a, optional_a);
    climb(b, from_b, optional_b);
  }
  return compare_siblings({a, optional_a}, {b, optional_b}, in_order);
}

/// Where two chains part: the siblings below their closest common requester. Nil: one is a part of the other.
Order::Parting Order::parting(Place a, Place b, Index length_a, Index length_b) const {
  bool optional_a = false, optional_b = false;
  const auto climb = [&](Place& place, bool& is_optional) {
    is_optional = is_optional || optional(place.edge);
    place.edge = above(place);
  };
  for (Index i = length_b; i < length_a; ++i) climb(a, optional_a);
  for (Index i = length_a; i < length_b; ++i) climb(b, optional_b);
  Parting out{{nil, false}, {nil, false}};
  while (a.edge != nil) {
    const Index at_a = a.edge, at_b = b.edge;
    if (at_a == at_b && a.along == b.along) break; // and so is all above
    climb(a, optional_a);
    climb(b, optional_b);
    if (at_a != at_b) out = {{at_a, optional_a}, {at_b, optional_b}};
  }
  return out;
}

int Order::compare_chains(Place a, Place b, bool in_order) const {
  if (lineage_is_valid_ && a.along == Chains::current && b.along == Chains::current && claimed(requester(a.edge)) &&
      claimed(requester(b.edge)))
    return compare_claimed(a.edge, b.edge, in_order);
  const Chain of_a = chain(a), of_b = chain(b);
  const bool limbo_a = is_limbo(of_a.top), limbo_b = is_limbo(of_b.top);
  if (limbo_a != limbo_b) return limbo_a ? 1 : -1;
  const Parting siblings = parting(a, b, of_a.length, of_b.length);
  if (siblings.a.edge == nil && injected(Fault::ancestors_are_equals)) return 0;
  if (siblings.a.edge == nil) return of_a.length < of_b.length ? -1 : of_a.length > of_b.length ? 1 : 0; // rule 1
  return compare_siblings(siblings.a, siblings.b, in_order);
}

/// Neither they nor anything below one of them can be equal.
bool Order::never_equal(Place a, Place b) const {
  const Chain of_a = chain(a), of_b = chain(b);
  if (is_limbo(of_a.top) || is_limbo(of_b.top)) return false;
  const Parting siblings = parting(a, b, of_a.length, of_b.length);
  return siblings.a.edge != nil && urgency(siblings.a.edge) != urgency(siblings.b.edge);
}

void Order::sort(std::span<Index> groups, Chains along) const {
  heap_sort(groups, [&](Index a, Index b) { return before_in_order(a, b, along); });
}

} // namespace director
