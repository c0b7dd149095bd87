// docs/semantics.md, section 4.1: which of two edges goes first.
// SPDX-License-Identifier: MIT
//
// Along both chains from the bottom up at equal height, the pair of different edges nearest to root is where they part:
// all below it belongs to one side only. One walk finds that pair and whether something optional lies on either side.
// Cost: the length of the longer chain.

#include "runtime/core/arbitration/order.hpp"

#include "runtime/core/arbitration/claims.hpp"
#include "runtime/core/base/fault_injection.hpp"
#include "runtime/core/base/heap_sort.hpp"

namespace director::arbitration {

namespace {

struct Parting {
  Side a, b;
};

/// Where two chains part: the siblings below their closest common requester. Nil: one is a part of the other.
Parting parting(const Context& x, Place a, Place b, Index length_a, Index length_b) {
  bool optional_a = false, optional_b = false;
  const auto climb = [&](Place& place, bool& is_optional) {
    is_optional = is_optional || optional(x, place.edge);
    place.edge = above(x, place);
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

} // namespace

/// Two edges whose chains end with the same edge of root: their depths are known, and chains that have met stay
/// together.
int compare_relatives(const Context& x, Index a, Index b, bool in_order) {
  const Edge* const edges = x.t.edges.data();
  const GroupAssignment* const now = x.s.now.group;
  Index from_a = edges[a].requester, from_b = edges[b].requester;
  Index depth_a = from_a == nil ? Index{0} : x.s.lineage[from_a].depth,
        depth_b = from_b == nil ? Index{0} : x.s.lineage[from_b].depth;
  bool optional_a = optional(x, a), optional_b = optional(x, b);
  const auto climb = [&](Index& edge, Index& from, bool& is_optional) {
    edge = now[from].holder;
    from = edges[edge].requester;
    is_optional = is_optional || optional(x, edge);
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
  return compare_siblings(x, {a, optional_a}, {b, optional_b}, in_order);
}

int compare_chains(const Context& x, Place a, Place b, bool in_order) {
  if (x.lineage_is_valid && a.along == Chains::current && b.along == Chains::current &&
      claimed(x, requester(x, a.edge)) && claimed(x, requester(x, b.edge)))
    return compare_claimed(x, a.edge, b.edge, in_order);
  const Chain of_a = chain(x, a), of_b = chain(x, b);
  const bool limbo_a = is_limbo(x, of_a.top), limbo_b = is_limbo(x, of_b.top);
  if (limbo_a != limbo_b) return limbo_a ? 1 : -1;
  const Parting siblings = parting(x, a, b, of_a.length, of_b.length);
  if (siblings.a.edge == nil && injected(Fault::ancestors_are_equals)) return 0;
  if (siblings.a.edge == nil) return of_a.length < of_b.length ? -1 : of_a.length > of_b.length ? 1 : 0; // rule 1
  return compare_siblings(x, siblings.a, siblings.b, in_order);
}

/// Neither they nor anything below one of them can be equal.
bool never_equal(const Context& x, Place a, Place b) {
  const Chain of_a = chain(x, a), of_b = chain(x, b);
  if (is_limbo(x, of_a.top) || is_limbo(x, of_b.top)) return false;
  const Parting siblings = parting(x, a, b, of_a.length, of_b.length);
  return siblings.a.edge != nil && urgency(x, siblings.a.edge) != urgency(x, siblings.b.edge);
}

void sort_by_holders(const Context& x, std::span<Index> groups, Chains along) {
  heap_sort(groups, [&](Index a, Index b) { return before_in_order(x, a, b, along); });
}

} // namespace director::arbitration
