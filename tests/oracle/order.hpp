#pragma once
// SPDX-License-Identifier: MIT
// semantics.md, 4.1: order between two edges, by their chains of holders up to root.

#include "tests/oracle/assignment.hpp"

namespace director::oracle {

/// An edge, the edge that holds its requester, and so on. Complete if it ends at root; below limbo it does not.
struct Chain {
  std::vector<EdgeId> edges;
  bool complete = false;

  EdgeId edge() const { return edges.front(); }
  bool below(EdgeId ancestor) const; ///< `ancestor` is a true ancestor of the edge
};

using Holders = IdTable<GroupId, std::optional<Held>>;

Chain chain_of(const Parts& parts, const Holders& holders, EdgeId edge);
/// The chain of an edge of a group that is held by the edge of another chain, or would be.
Chain below(const Chain& holder, EdgeId edge);

class Order {
public:
  Order(const Parts& parts, const Facts& facts) : parts_(parts), facts_(facts) {}

  /// Rules 1 to 4 only: "before". If neither is before the other, they are equal.
  bool before(const Chain& a, const Chain& b) const;
  bool equal(const Chain& a, const Chain& b) const { return !before(a, b) && !before(b, a); }
  /// With rule 5: "in order", a total order.
  bool first(const Chain& a, const Chain& b) const;

private:
  /// The two siblings below the closest common requester, and whether an edge on the way from there is optional.
  struct Fork {
    EdgeId a{}, b{};
    bool optional_a = false, optional_b = false;
  };
  std::optional<Fork> fork(const Chain& a, const Chain& b) const; ///< nothing if one is an ancestor of the other
  Level level(EdgeId edge) const;
  std::uint64_t stamp(EdgeId edge) const;
  int compare(const Chain& a, const Chain& b) const; ///< rules 1 to 4: below 0 if a goes first, 0 if equal

  const Parts& parts_;
  const Facts& facts_;
};

} // namespace director::oracle
