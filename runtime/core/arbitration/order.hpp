#pragma once
// SPDX-License-Identifier: MIT
// The order between two edges, each with the chain of its holders up to root. It is keyed by chains that move while the
// static ranks do not: the priority table of each requester (Level::urgency, Level::optional).
// docs/semantics.md, section 4.1.

#include "runtime/core/arbitration/claims.hpp"
#include "runtime/core/arbitration/context.hpp"
#include "runtime/core/base/fault_injection.hpp"

namespace director::arbitration {

struct Side {
  Index edge;
  bool optional; ///< it, or something below it
};

int compare_relatives(const Context& x, Index a, Index b, bool in_order);
int compare_chains(const Context& x, Place a, Place b, bool in_order);
bool never_equal(const Context& x, Place a, Place b);
void sort_by_holders(const Context& x, std::span<Index> groups, Chains along);

/// Rules 3 to 5 for two edges of one requester and what lies below them.
inline int compare_siblings(const Context& x, Side a, Side b, bool in_order) {
  if (a.optional != b.optional) return a.optional != injected(Fault::optional_goes_first) ? 1 : -1; // rule 3
  const Index urgency_a = urgency(x, a.edge), urgency_b = urgency(x, b.edge);
  if (urgency_a != urgency_b) // rule 4
    return (urgency_a < urgency_b) != injected(Fault::priorities_are_reversed) ? -1 : 1;
  if (!in_order) return 0;
  const auto stamp = [&](Index edge) { return requested(x, edge) ? x.s.request[edge].stamp : ~std::uint64_t{0}; };
  if (stamp(a.edge) != stamp(b.edge)) // rule 5
    return (stamp(a.edge) < stamp(b.edge)) != injected(Fault::younger_goes_first) ? -1 : 1;
  return a.edge < b.edge ? -1 : 1;
}

/// Of an edge whose requester is claimed or root.
inline Side below_root(const Context& x, Index edge) {
  const Index from = x.t.edges[edge].requester;
  if (from == nil) return {edge, optional(x, edge)};
  return {x.s.lineage[from].top, x.s.lineage[from].optional || optional(x, edge)};
}

/// Two edges whose requesters are claimed in this pass, or root. Mostly their chains have nothing in common.
inline int compare_claimed(const Context& x, Index a, Index b, bool in_order) {
  if (x.t.edges[a].requester == x.t.edges[b].requester)
    return a == b ? 0 : compare_siblings(x, {a, optional(x, a)}, {b, optional(x, b)}, in_order);
  const Side at_a = below_root(x, a), at_b = below_root(x, b);
  return at_a.edge != at_b.edge ? compare_siblings(x, at_a, at_b, in_order) : compare_relatives(x, a, b, in_order);
}

/// Negative: `a` goes first; 0: equal (by rules 1 to 4), or the same. `in_order`: with rule 5, total.
inline int compare(const Context& x, Place a, Place b, bool in_order) {
  if (a.along != b.along || is_limbo(x, a.edge) || is_limbo(x, b.edge) ||
      x.t.edges[a.edge].requester != x.t.edges[b.edge].requester)
    return compare_chains(x, a, b, in_order);
  return a.edge == b.edge ? 0
                          : compare_siblings(x, {a.edge, optional(x, a.edge)}, {b.edge, optional(x, b.edge)}, in_order);
}

inline bool before(const Context& x, Place a, Place b) { return compare(x, a, b, false) < 0; }

/// The edge that holds group `a` goes before the one that holds `b`, in order.
inline bool before_in_order(const Context& x, Index a, Index b, Chains along) {
  const Assignment& held = along == Chains::current ? x.s.now : x.s.last;
  if (requester(x, held[b].holder) == a && !is_limbo(x, held[b].holder)) return true; // its own requester
  if (requester(x, held[a].holder) == b && !is_limbo(x, held[a].holder)) return false;
  if (x.lineage_is_valid && along == Chains::current)
    return compare_claimed(x, held[a].holder, held[b].holder, true) < 0;
  return compare(x, {held[a].holder, along}, {held[b].holder, along}, true) < 0;
}

/// Of two candidates: their requesters are claimed or root.
inline bool goes_first(const Context& x, Index a, Index b) {
  return (x.lineage_is_valid ? compare_claimed(x, a, b, true)
                             : compare(x, {a, Chains::current}, {b, Chains::current}, true)) < 0;
}

} // namespace director::arbitration
