#pragma once
// Section 4.1: the order between two edges, each with the chain of its holders up to root. It is keyed by chains that
// move while the static ranks do not: the priority table of each requester (Level::urgency, Level::optional).

#include "runtime/core/state.hpp"
#include "runtime/core/tables.hpp"

namespace director {

class Order {
public:
  Order(const Tables& tables, State& state) : t_(tables), s_(state) {}

  /// Which claims a chain is read along: those of this pass (and of the combination in hand), or the last assignment.
  enum class Along : std::uint8_t { now, last };
  struct Place {
    Index edge;
    Along along;
  };

  /// Negative: `a` goes first; 0: equal (by rules 1 to 4), or the same. `in_order`: with rule 5, total.
  int compare(Place a, Place b, bool in_order) const;
  bool before(Place a, Place b) const { return compare(a, b, false) < 0; }
  bool in_chain(Index edge, Place of) const;

  /// The edge that holds group `a` goes before the one that holds `b`, in order.
  bool before_in_order(Index a, Index b, Along along) const {
    const Assignment& held = along == Along::now ? s_.now : s_.last;
    return compare({held[a].holder, along}, {held[b].holder, along}, true) < 0;
  }
  /// Sorts groups by the edges that hold them.
  void sort(std::span<Index> groups, Along along) const;

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
  int compare_siblings(Side a, Side b, bool in_order) const;
  Index target(Index edge) const;
  Index requester(Index edge) const { return is_limbo(edge) ? nil : t_.edges[edge].requester; }
  bool requested(Index edge) const { return !is_limbo(edge) && s_.request[edge] != nil; }
  Index above(Place place) const;
  Chain chain(Place place) const;
  bool optional(Index edge) const;
  Index urgency(Index edge) const;

  const Tables& t_;
  State& s_;
};

} // namespace director
