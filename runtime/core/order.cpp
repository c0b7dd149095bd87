// Door: runtime/core/order.hpp. Test: tests/runtime/core/arbitration_test.cpp.
//
// Section 4.1: the order between two edges. Along both chains from the bottom up at equal height, the pair of different
// edges nearest to root is where they part: all below it belongs to one side only. One walk finds that pair and whether
// something optional lies on either side. Cost: the length of the longer chain.

#include "runtime/core/order.hpp"

#include "runtime/core/heap_sort.hpp"
#include "runtime/core/planted.hpp"

namespace director {

Index Order::target(Index edge) const {
  return is_limbo(edge) ? static_cast<Index>(edge - t_.edges.size()) : t_.edges[edge].target;
}

bool Order::optional(Index edge) const { return requested(edge) && t_.levels[s_.request[edge]].optional; }

Index Order::urgency(Index edge) const {
  if (is_limbo(edge)) return 0;
  return s_.request[edge] == nil ? t_.edges[edge].need_urgency : t_.levels[s_.request[edge]].urgency;
}

/// The edge that controls the requester of this one. A claim counts before a trial: a plan in hand may name a group
/// that is claimed already, even one above it; it cannot be chosen, but it must not bend the chains.
Index Order::above(Place place) const {
  const Index group = requester(place.edge);
  if (group == nil) return nil;
  if (place.along == Along::last) return s_.last[group].holder;
  return s_.now[group].holder != nil ? s_.now[group].holder : s_.trial[group];
}

Order::Chain Order::chain(Place place) const {
  Chain out;
  for (; place.edge != nil; place.edge = above(place)) {
    ++out.length;
    if (requester(place.edge) == nil) out.top = place.edge;
  }
  return out;
}

bool Order::in_chain(Index edge, Place of) const {
  for (; of.edge != nil; of.edge = above(of)) {
    if (of.edge == edge) return true;
  }
  return false;
}

/// Negative: `a` goes first; 0: equal (by rules 1 to 4), or the same. `in_order`: with rule 5.
int Order::compare(Place a, Place b, bool in_order) const {
  if (a.along == b.along && requester(a.edge) == requester(b.edge) && !is_limbo(a.edge) && !is_limbo(b.edge)) {
    if (a.edge == b.edge) return 0;
    return compare_siblings({a.edge, optional(a.edge)}, {b.edge, optional(b.edge)}, in_order);
  }
  const Chain of_a = chain(a), of_b = chain(b);
  const bool limbo_a = is_limbo(of_a.top), limbo_b = is_limbo(of_b.top);
  if (limbo_a != limbo_b) return limbo_a ? 1 : -1;

  bool optional_a = false, optional_b = false;
  const auto climb = [&](Place& place, bool& is_optional) {
    is_optional = is_optional || optional(place.edge);
    place.edge = above(place);
  };
  for (Index i = of_b.length; i < of_a.length; ++i) climb(a, optional_a);
  for (Index i = of_a.length; i < of_b.length; ++i) climb(b, optional_b);

  Index sibling_a = nil, sibling_b = nil;
  bool below_a = false, below_b = false; // something optional at the siblings or below them
  while (a.edge != nil) {
    const Index at_a = a.edge, at_b = b.edge;
    climb(a, optional_a);
    climb(b, optional_b);
    if (at_a != at_b) sibling_a = at_a, sibling_b = at_b, below_a = optional_a, below_b = optional_b;
  }
  if (sibling_a == nil && planted(Fault::ancestors_are_equals)) return 0;
  if (sibling_a == nil) return of_a.length < of_b.length ? -1 : of_a.length > of_b.length ? 1 : 0; // rule 1
  return compare_siblings({sibling_a, below_a}, {sibling_b, below_b}, in_order);
}

/// Rules 3 to 5 for two edges of one requester and what lies below them.
int Order::compare_siblings(Side a, Side b, bool in_order) const {
  if (a.optional != b.optional) return a.optional != planted(Fault::optional_goes_first) ? 1 : -1; // rule 3
  const Index urgency_a = urgency(a.edge), urgency_b = urgency(b.edge);
  if (urgency_a != urgency_b) // rule 4
    return (urgency_a < urgency_b) != planted(Fault::priorities_are_reversed) ? -1 : 1;
  if (!in_order) return 0;
  const auto stamp = [&](Index edge) { return requested(edge) ? s_.stamp[edge] : ~std::uint64_t{0}; };
  if (stamp(a.edge) != stamp(b.edge)) // rule 5
    return (stamp(a.edge) < stamp(b.edge)) != planted(Fault::younger_goes_first) ? -1 : 1;
  return a.edge < b.edge ? -1 : 1;
}

void Order::sort(std::span<Index> groups, Along along) const {
  heap_sort(groups, [&](Index a, Index b) { return before_in_order(a, b, along); });
}

} // namespace director
