// Header: tests/oracle/order.hpp. Test: tests/oracle/order_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/oracle/order.hpp"

#include <algorithm>
#include <limits>

namespace director::oracle {

bool Chain::below(EdgeId ancestor) const { return std::find(edges.begin() + 1, edges.end(), ancestor) != edges.end(); }

Chain chain_of(const Parts& parts, const Holders& holders, EdgeId edge) {
  Chain chain{{edge}, false};
  while (const std::optional<GroupId> requester = parts.requester(chain.edges.back())) {
    if (!holders[*requester]) return chain;
    chain.edges.push_back(holders[*requester]->by);
  }
  chain.complete = !parts.is_limbo(chain.edges.back());
  return chain;
}

Chain below(const Chain& holder, EdgeId edge) {
  Chain chain{{edge}, holder.complete};
  chain.edges.insert(chain.edges.end(), holder.edges.begin(), holder.edges.end());
  return chain;
}

Level Order::level(EdgeId edge) const {
  if (parts_.is_limbo(edge)) return {};
  const std::vector<Level>& levels = parts_.model().edges[edge].levels;
  if (const auto& request = facts_.request[edge]) return levels.at(request->level);
  return {levels.empty() ? 0 : levels.front().priority, false, false};
}

std::uint64_t Order::stamp(EdgeId edge) const {
  const bool requested = !parts_.is_limbo(edge) && facts_.request[edge];
  return requested ? facts_.request[edge]->stamp : std::numeric_limits<std::uint64_t>::max();
}

// Seen from root: the last requester up to which both chains are the same. Chains of one assignment cannot meet again
// behind it. A claimed chain and a previous one can; that does not count, because they arrived there in different ways.
std::optional<Order::Fork> Order::fork(const Chain& a, const Chain& b) const {
  const auto [at_a, at_b] = std::mismatch(a.edges.rbegin(), a.edges.rend(), b.edges.rbegin(), b.edges.rend());
  if (at_a == a.edges.rend() || at_b == b.edges.rend()) return std::nullopt;
  const auto optional = [&](EdgeId edge) { return level(edge).optional; };
  return Fork{*at_a, *at_b, std::any_of(at_a, a.edges.rend(), optional), std::any_of(at_b, b.edges.rend(), optional)};
}

int Order::compare(const Chain& a, const Chain& b) const {
  const std::optional<Fork> parted = fork(a, b);                                           // 2
  if (!parted) return static_cast<int>(a.edges.size()) - static_cast<int>(b.edges.size()); // 1
  const Fork& at = *parted;
  if (parts_.is_limbo(at.a) != parts_.is_limbo(at.b)) return parts_.is_limbo(at.a) ? 1 : -1; // limbo edges are last
  if (at.optional_a != at.optional_b) return at.optional_a ? 1 : -1;                         // 3
  const std::int32_t pa = level(at.a).priority, pb = level(at.b).priority;                   // 4
  return pa > pb ? -1 : pa < pb ? 1 : 0;
}

bool Order::before(const Chain& a, const Chain& b) const { return compare(a, b) < 0; }

bool Order::first(const Chain& a, const Chain& b) const {
  if (const int rules = compare(a, b); rules != 0) return rules < 0;
  const std::optional<Fork> parted = fork(a, b); // 5
  if (!parted) return false;
  const Fork& at = *parted;
  return stamp(at.a) != stamp(at.b) ? stamp(at.a) < stamp(at.b) : at.a < at.b;
}

} // namespace director::oracle
