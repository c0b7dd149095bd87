#pragma once
// SPDX-License-Identifier: MIT
// Who decides between two edges to one group, over all chains of requesters that lead to them. Source:
// semantics.md 4.1. Only people ask this: the engine compares the two chains that there are at the moment.

#include "compiler/model/model.hpp"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace director::compiler {

/// How one side stands below the common requester.
struct Standing {
  std::int32_t priority = 0; ///< of the sibling edge
  bool optional = false;     ///< something on the chain from the sibling down is
  auto operator<=>(const Standing&) const = default;
};

/// At one common requester, for one pair of its edges and one way in which each may be asked for.
struct Decision {
  std::optional<GroupId> requester; ///< nothing: root
  EdgeId first_sibling{}, second_sibling{};
  Standing first, second;
  bool operator==(const Decision&) const = default;
};

/// Negative: the first edge goes before the second; 0: they are equal.
int order_of(const Decision& decision);

struct Contention {
  EdgeId first{}, second{};        ///< two edges to one group, by id
  std::vector<Decision> decisions; ///< different ones only; none: no two chains lead to them at once
  bool complete = true;            ///< false: the search ended at its bound
};

/// Pairs of chains that are looked at for one group, and steps upwards along the chains of one edge. A servo of a real
/// team's robot has less than a thousand; what has more than this nobody reads.
inline constexpr std::size_t most_chain_pairs = 4'000;

/// All pairs of edges to the group, in order.
std::vector<Contention> contentions(const Model& model, GroupId group, std::size_t most_pairs = most_chain_pairs);

} // namespace director::compiler
