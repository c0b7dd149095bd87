#pragma once
// SPDX-License-Identifier: MIT
// The order between two edges, each with the chain of its holders up to root: by the claims of the current pass, or by
// the last assignment. Rules 1 to 4 compare static ranks along these chains, of the priority table of each requester
// (Level::urgency, Level::optional). docs/semantics.md, section 4.1.

#include "runtime/core/arbitration/context.hpp"
#include "runtime/core/base/inline.hpp"

namespace director::arbitration {

/// The holders that a chain follows: those of this pass (and of the current combination), or of the last one.
enum class Chains : std::uint8_t { current, previous };

struct Place {
  Index edge;
  Chains along;
};

struct Chain {
  Index length = 0;
  Index top = nil; ///< its edge of root or limbo; nil, which counts as limbo, if the chain does not reach so far
};

/// One of two siblings below the closest common requester.
struct Side {
  Index edge = nil;
  bool optional = false; ///< it, or an edge below it
};

/// The edges at which two chains part; nil: one chain is a part of the other.
struct Parting {
  Side a, b;
};

/// The edge that goes first of two, and the rule. `order`: negative, the first one; 0: they are equal, or the same.
struct Verdict {
  Precedence by;
  int order;
};

/// Climbs both chains at equal height; the last pair of different edges is where they part: all below it belongs to one
/// side only. Cost: the longer chain. `above(place)`: the next edge of its chain; nil behind the last.
template <class Next, class Optional>
Parting parting(Place a, Place b, Index length_a, Index length_b, const Next& above, const Optional& optional) {
  bool optional_a = false, optional_b = false;
  const auto climb = [&](Place& place, bool& is_optional) {
    is_optional = is_optional || optional(place.edge);
    place.edge = above(place);
  };
  for (Index i = length_b; i < length_a; ++i) climb(a, optional_a);
  for (Index i = length_a; i < length_b; ++i) climb(b, optional_b);
  Parting out;
  while (a.edge != nil) {
    const Index at_a = a.edge, at_b = b.edge;
    if (at_a == at_b && a.along == b.along) break; // and all above is the same
    climb(a, optional_a);
    climb(b, optional_b);
    if (at_a != at_b) out = {{at_a, optional_a}, {at_b, optional_b}};
  }
  return out;
}

/// Rules 3 and 4.
inline Verdict compare_ranks(Side a, Side b, Index urgency_a, Index urgency_b) {
  if (a.optional != b.optional) return {Precedence::optional, a.optional ? 1 : -1};
  if (urgency_a == urgency_b) return {Precedence::equal, 0};
  return {Precedence::priority, urgency_a < urgency_b ? -1 : 1};
}

/// The urgency of an edge that is requested at this level; nil: that holds its target without a request.
inline Index urgency(const Tables& t, Index edge, Index level) {
  return level == nil ? t.edges[edge].need_urgency : t.levels[level].urgency;
}

DIRECTOR_PART bool is_passed(const Context& x, Index group); // trail.cpp
Chain chain(const Context& x, Place place);
bool in_chain(const Context& x, Index edge, Place of);
DIRECTOR_PART int compare_chains(const Context& x, Place a, Place b, bool in_order);
DIRECTOR_PART void sort_by_holders(const Context& x, std::span<Index> groups, Chains along);
DIRECTOR_PART void sort_by_place(const Context& x, std::span<Index> groups, Chains along);
DIRECTOR_PART void sort_roots(Context& x);

inline bool is_limbo(const Context& x, Index edge) { return edge >= x.t.edges.size(); }

/// The edge must not be limbo.
inline Index target(const Context& x, Index edge) { return x.t.edges[edge].target; }

inline Index requester(const Context& x, Index edge) { return is_limbo(x, edge) ? nil : x.t.edges[edge].requester; }

inline bool requested(const Context& x, Index edge) { return !is_limbo(x, edge) && x.s.request[edge].level != nil; }

/// The edge must not be limbo.
inline bool optional(const Context& x, Index edge) {
  const Index level = x.s.request[edge].level;
  return level != nil && x.t.levels[level].optional;
}

inline Index urgency(const Context& x, Index edge) {
  return is_limbo(x, edge) ? Index{0} : urgency(x.t, edge, x.s.request[edge].level);
}

inline Index requester_of_holder(const Context& x, const GroupAssignment& assignment) {
  return assignment.holder == nil ? nil : requester(x, assignment.holder);
}

/// Whether the group, which is held, is in limbo in the last assignment, or below such a group.
inline bool was_in_limbo(const Context& x, Index group) {
  return is_limbo(x, chain(x, {x.s.last[group].holder, Chains::previous}).top);
}

inline bool holds(const Context& x, Index condition) { return x.s.truth[condition] != 0; }

/// Whether this pass has opened the group; otherwise it keeps the assignment of the last one.
inline bool is_opened(const Context& x, Index group) { return x.s.group_trail[group].has(trail::opened); }

/// The edge that has claimed the group so far. The holder of a group that is not opened counts once it is passed by.
inline Index holder_now(const Context& x, Index group) {
  const Index holder = x.s.now[group].holder;
  return holder == nil || !x.walking || is_opened(x, group) || is_passed(x, group) ? holder : nil;
}

/// Whether another edge has claimed the target. The edge must not be limbo, nor in was_granted.
inline bool taken(const Context& x, Index edge) {
  const Index holder = holder_now(x, target(x, edge));
  return holder != nil && holder != edge;
}

/// Whether the last pass granted the target to this edge.
inline bool was_granted(const Context& x, Index edge) {
  const GroupAssignment& last = x.s.last[target(x, edge)];
  return last.holder == edge && last.granted();
}

/// The edge that controls the requester of this one. A claim counts before a trial: the current plan may name a group
/// that is claimed already, even one above it; that plan is refused, but the chain must not follow it.
inline Index above(const Context& x, Place place) {
  const Index group = requester(x, place.edge);
  if (group == nil) return nil;
  if (place.along == Chains::previous) return x.s.last[group].holder;
  const Index holder = holder_now(x, group);
  return holder != nil ? holder : x.s.trial[group];
}

/// Compares two edges of one requester, with what is below them, by rules 3 to 5.
DIRECTOR_ONE_COPY inline int compare_siblings(const Context& x, Side a, Side b, bool in_order) {
  const int by_rank = compare_ranks(a, b, urgency(x, a.edge), urgency(x, b.edge)).order;
  if (by_rank != 0 || !in_order) return by_rank;
  const auto stamp = [&](Index edge) { return requested(x, edge) ? x.s.request[edge].stamp : ~std::uint64_t{0}; };
  if (stamp(a.edge) != stamp(b.edge)) return stamp(a.edge) < stamp(b.edge) ? -1 : 1; // rule 5
  return a.edge < b.edge ? -1 : 1;
}

inline int compare_siblings(const Context& x, Index a, Index b) {
  return compare_siblings(x, {a, optional(x, a)}, {b, optional(x, b)}, true);
}

/// Negative: `a` goes first; 0: they are equal (by rules 1 to 4), or the same. `in_order`: with rule 5, a total order.
DIRECTOR_ONE_COPY inline int compare(const Context& x, Place a, Place b, bool in_order) {
  if (a.along != b.along || is_limbo(x, a.edge) || is_limbo(x, b.edge) ||
      x.t.edges[a.edge].requester != x.t.edges[b.edge].requester)
    return compare_chains(x, a, b, in_order);
  return a.edge == b.edge ? 0
                          : compare_siblings(x, {a.edge, optional(x, a.edge)}, {b.edge, optional(x, b.edge)}, in_order);
}

inline bool before(const Context& x, Place a, Place b) { return compare(x, a, b, false) < 0; }

} // namespace director::arbitration
