#pragma once
// SPDX-License-Identifier: MIT
// Section 4.1: the order between two edges, each with the chain of its holders up to root. It is keyed by chains that
// move while the static ranks do not: the priority table of each requester (Level::urgency, Level::optional).

#include "runtime/core/base/marks.hpp"
#include "runtime/core/base/fault_injection.hpp"
#include "runtime/core/base/state.hpp"
#include "runtime/core/base/tables.hpp"

namespace director {

class Order {
public:
  Order(const Tables& tables, const State& state) : t_(tables), s_(state) {}

  /// Which claims a chain is read along: those of this pass (and of the combination in hand), or the last assignment.
  enum class Chains : std::uint8_t { current, previous };
  struct Place {
    Index edge;
    Chains along;
  };

  /// Negative: `a` goes first; 0: equal (by rules 1 to 4), or the same. `in_order`: with rule 5, total.
  int compare(Place a, Place b, bool in_order) const {
    if (a.along != b.along || is_limbo(a.edge) || is_limbo(b.edge) ||
        t_.edges[a.edge].requester != t_.edges[b.edge].requester)
      return compare_chains(a, b, in_order);
    return a.edge == b.edge ? 0 : compare_siblings({a.edge, optional(a.edge)}, {b.edge, optional(b.edge)}, in_order);
  }
  bool before(Place a, Place b) const { return compare(a, b, false) < 0; }
  bool in_chain(Index edge, Place of) const;

  /// The edge that holds group `a` goes before the one that holds `b`, in order.
  bool before_in_order(Index a, Index b, Chains along) const {
    const Assignment& held = along == Chains::current ? s_.now : s_.last;
    if (requester(held[b].holder) == a && !is_limbo(held[b].holder)) return true; // its own requester
    if (requester(held[a].holder) == b && !is_limbo(held[a].holder)) return false;
    if (lineage_is_valid_ && along == Chains::current) return compare_claimed(held[a].holder, held[b].holder, true) < 0;
    return compare({held[a].holder, along}, {held[b].holder, along}, true) < 0;
  }
  /// Sorts groups by the edges that hold them.
  void sort(std::span<Index> groups, Chains along) const;

protected:
  struct Chain {
    Index length = 0;
    Index top = nil; ///< its edge of root or limbo; nil where the chain does not reach that far
  };
  bool is_limbo(Index edge) const { return edge >= t_.edges.size(); }
  struct Side {
    Index edge;
    bool optional; ///< it, or something below it
  };
  struct Parting {
    Side a, b;
  };
  Parting parting(Place a, Place b, Index length_a, Index length_b) const;
  bool never_equal(Place a, Place b) const;
  int compare_chains(Place a, Place b, bool in_order) const;
  /// Of an edge whose requester is claimed or root.
  Side below_root(Index edge) const {
    const Index from = t_.edges[edge].requester;
    if (from == nil) return {edge, optional(edge)};
    return {s_.lineage[from].top, s_.lineage[from].optional || optional(edge)};
  }
  /// Two edges whose requesters are claimed in this pass, or root. Mostly their chains have nothing in common.
  int compare_claimed(Index a, Index b, bool in_order) const {
    if (t_.edges[a].requester == t_.edges[b].requester)
      return a == b ? 0 : compare_siblings({a, optional(a)}, {b, optional(b)}, in_order);
    const Side at_a = below_root(a), at_b = below_root(b);
    return at_a.edge != at_b.edge ? compare_siblings(at_a, at_b, in_order) : compare_relatives(a, b, in_order);
  }
  int compare_relatives(Index a, Index b, bool in_order) const;
  int compare_siblings(Side a, Side b, bool in_order) const;
  Index target(Index edge) const {
    return is_limbo(edge) ? static_cast<Index>(edge - t_.edges.size()) : t_.edges[edge].target;
  }
  Index requester(Index edge) const { return is_limbo(edge) ? nil : t_.edges[edge].requester; }
  bool requested(Index edge) const { return !is_limbo(edge) && s_.request[edge].level != nil; }
  /// The edge that controls the requester of this one. A claim counts before a trial: a plan in hand may name a group
  /// that is claimed already, even one above it; it cannot be chosen, but it must not bend the chains.
  Index above(Place place) const {
    const Index group = requester(place.edge);
    if (group == nil) return nil;
    if (place.along == Chains::previous) return s_.last[group].holder;
    const Index holder = holder_now(group);
    return holder != nil ? holder : s_.trial[group];
  }
  /// In this pass; root always is.
  bool claimed(Index group) const { return group == nil || holder_now(group) != nil; }
  /// The edge that has claimed the group so far. One that the pass in hand has not opened stands as in the last pass, and
  /// counts from where the walk passes it.
  Index holder_now(Index group) const {
    const Index holder = s_.now[group].holder;
    return holder == nil || !walking_ || is_opened(group) || is_passed(group) ? holder : nil;
  }
  bool is_opened(Index group) const { return (s_.group_trail[group] & trail::opened) != 0; }
  bool is_passed(Index group) const;
  Index requester_of_holder(const GroupAssignment& standing) const {
    return standing.holder == nil ? nil : requester(standing.holder);
  }
  Chain chain(Place place) const;
  bool optional(Index edge) const { return requested(edge) && t_.levels[s_.request[edge].level].optional; }
  Index urgency(Index edge) const {
    if (is_limbo(edge)) return 0;
    return s_.request[edge].level == nil ? t_.edges[edge].need_urgency : t_.levels[s_.request[edge].level].urgency;
  }

  const Tables t_;
  State s_;
  bool walking_ = false;  ///< a pass is on its way along the order
  bool lineage_is_valid_ = false; ///< State::lineage holds for what is claimed now, and nothing of it is in limbo
};

/// Rules 3 to 5 for two edges of one requester and what lies below them.
inline int Order::compare_siblings(Side a, Side b, bool in_order) const {
  if (a.optional != b.optional) return a.optional != injected(Fault::optional_goes_first) ? 1 : -1; // rule 3
  const Index urgency_a = urgency(a.edge), urgency_b = urgency(b.edge);
  if (urgency_a != urgency_b) // rule 4
    return (urgency_a < urgency_b) != injected(Fault::priorities_are_reversed) ? -1 : 1;
  if (!in_order) return 0;
  const auto stamp = [&](Index edge) { return requested(edge) ? s_.request[edge].stamp : ~std::uint64_t{0}; };
  if (stamp(a.edge) != stamp(b.edge)) // rule 5
    return (stamp(a.edge) < stamp(b.edge)) != injected(Fault::younger_goes_first) ? -1 : 1;
  return a.edge < b.edge ? -1 : 1;
}

} // namespace director
