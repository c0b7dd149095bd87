// docs/semantics.md, section 4.1: the chains of holders, and which of two edges goes first.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/order.hpp"

#include "runtime/core/base/heap_sort.hpp"

const char director::part::order = 0;

namespace director::arbitration {

namespace {

/// Whether the holder of group `a` goes before that of `b`, in order.
bool before_in_order(const Context& x, Index a, Index b, Chains along) {
  const Assignment& held = along == Chains::current ? x.s.now : x.s.last;
  return compare(x, {held[a].holder, along}, {held[b].holder, along}, true) < 0;
}

} // namespace

Chain chain(const Context& x, Place place) {
  Chain out;
  for (; place.edge != nil; place.edge = above(x, place)) {
    ++out.length;
    if (requester(x, place.edge) == nil) out.top = place.edge;
  }
  return out;
}

bool in_chain(const Context& x, Index edge, Place of) {
  for (; of.edge != nil; of.edge = above(x, of)) {
    if (of.edge == edge) return true;
  }
  return false;
}

int compare_chains(const Context& x, Place a, Place b, bool in_order) {
  const Chain of_a = chain(x, a), of_b = chain(x, b);
  const bool limbo_a = is_limbo(x, of_a.top), limbo_b = is_limbo(x, of_b.top);
  if (limbo_a != limbo_b) return limbo_a ? 1 : -1;
  const Parting at = parting(
      a, b, of_a.length, of_b.length, [&](Place place) { return above(x, place); },
      [&](Index edge) { return !is_limbo(x, edge) && optional(x, edge); });
  if (at.a.edge != nil) return compare_siblings(x, at.a, at.b, in_order);
  return of_a.length < of_b.length ? -1 : of_a.length > of_b.length ? 1 : 0; // rule 1
}

void sort_by_holders(const Context& x, std::span<Index> groups, Chains along) {
  heap_sort(groups, [&](Index a, Index b) { return before_in_order(x, a, b, along); });
}

/// Sorts groups of any components; those of one component by their places.
DIRECTOR_FLATTEN void sort_by_place(const Context& x, std::span<Index> groups, Chains along) {
  heap_sort(groups, [&](Index a, Index b) {
    if (x.s.run_queue[a].component == x.s.run_queue[b].component) return x.s.place[a] < x.s.place[b];
    return before_in_order(x, a, b, along);
  });
}

/// Sorts the edges of root of the component, a linked list that stays from pass to pass: few move, mostly none.
void sort_roots(Context& x) {
  const auto comes_first = [&](Index a, Index b) { return compare_siblings(x, a, b) < 0; };
  const auto may_have_moved = [&](Index e) { return x.whole || x.s.edge_trail[e].has(trail::reached); };
  Index* link = &x.s.first_root[x.component];
  Index last = nil, moved = 0;
  for (Index e = *link; e != nil;) {
    const Index following = x.s.next_root[e];
    if (last != nil && (may_have_moved(e) || may_have_moved(last)) && comes_first(e, last)) {
      x.s.candidate[moved++] = e;
    } else {
      *link = e;
      link = &x.s.next_root[e];
      last = e;
    }
    e = following;
  }
  *link = nil;
  heap_sort({x.s.candidate, moved}, comes_first);
  link = &x.s.first_root[x.component];
  for (Index i = 0; i < moved; ++i) {
    const Index e = x.s.candidate[i];
    while (*link != nil && comes_first(*link, e)) link = &x.s.next_root[*link];
    x.s.next_root[e] = *link;
    *link = e;
    link = &x.s.next_root[e];
  }
}

} // namespace director::arbitration
