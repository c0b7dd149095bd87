#pragma once
// SPDX-License-Identifier: MIT
// Finds the decisions between two edges to one group, over all chains of requesters that lead to them. Source:
// semantics.md 4.1. Only for documentation: the engine compares the two current chains.

#include "compiler/model/model.hpp"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace director::analysis {

using namespace director::compiler;

/// The rank of one side below the common requester.
struct SideRank {
  std::int32_t priority = 0; ///< of the sibling edge
  bool optional = false;     ///< something on the chain from the sibling down is optional
  auto operator<=>(const SideRank&) const = default;
};

/// The ranks of two tasks by which the first goes before the second.
struct Winning {
  SideRank first, second;
  auto operator<=>(const Winning&) const = default;
};

/// The decision at one common requester, for one pair of its edges and one level of each.
struct Decision {
  std::optional<GroupId> requester; ///< nothing: root
  EdgeId first_sibling{}, second_sibling{};
  SideRank first, second;
  auto operator<=>(const Decision&) const = default;
};

/// Negative: the first edge goes before the second; 0: they are equal.
int order_of(const Decision& decision);

/// Two edges to one group, by id.
struct Contention {
  EdgeId first{}, second{};
  std::vector<Decision> decisions; ///< without duplicates; none: no two chains lead to them at once
  bool complete = true;            ///< false: the search ended at its bound
};

/// Limit for all pairs of edges. A real team's robot has some ten thousand; a larger result is not readable.
inline constexpr std::size_t most_edge_pairs = 1'000'000;

/// Limit for the places where two chains part, counted for each pair of edges: 12 bytes each are kept.
inline constexpr std::size_t most_partings = 5'000'000;

/// Limit for steps through cycles of requests: with forty groups that all request each other the result is not
/// readable.
inline constexpr std::size_t most_cycle_steps = 4'000'000;

/// Keeps intermediate results between queries.
class Contentions {
public:
  explicit Contentions(const Model& model, std::size_t pairs = most_edge_pairs, std::size_t partings = most_partings);

  /// All pairs of edges to the group, in order.
  std::vector<Contention> at(GroupId group);
  /// All decisions between a chain to the one and a chain to the other. `first` of a decision is on the side of the
  /// first group. Of a group and itself: two chains to it.
  std::vector<Decision> between(GroupId first, GroupId second);
  /// False: some search ended at its bound.
  bool complete() const { return pairs_left_ > 0 && partings_left_ > 0 && cycle_steps_left_ > 0; }

private:
  /// The edges below the closest common requester, and whether something optional lies below them.
  struct Parting {
    EdgeId first{}, second{};
    bool first_optional = false, second_optional = false;
    auto operator<=>(const Parting&) const = default;
  };
  using Partings = std::vector<Parting>; ///< sorted

  struct Known {
    Partings all;
    bool settled = false, open = false;
    std::size_t round = 0; ///< in which it was examined last
  };

  const Partings& partings(EdgeId first, EdgeId second);
  const Partings& look_at(EdgeId first, EdgeId second);
  Partings find(EdgeId first, EdgeId second);
  void climb(EdgeId first, EdgeId second, bool climbs_first, Partings& out);
  std::vector<Decision> decisions(const Partings& partings) const;

  /// Of one that is only the last of a chain.
  EdgeId original(EdgeId edge) const { return edge.value < model_.edges.size() ? edge : last_[edge]; }

  const Model& model_;
  IdTable<EdgeId, compiler::Edge> edges_; ///< those of the model, then those that are only the last of a chain
  IdTable<EdgeId, EdgeId> last_; ///< by edge of the model: itself as the last of a chain; of the others: the original
  std::size_t pairs_left_, partings_left_;
  IdTable<GroupId, std::size_t> place_; ///< requesters first
  IdTable<GroupId, char> is_requested_; ///< some chain from root leads to it
  IdTable<GroupId, std::size_t> cycle_; ///< the number of its cycle; 0: none
  std::map<std::pair<EdgeId, EdgeId>, Known> known_;
  std::vector<Known*> unsettled_; ///< what the current query examines
  std::size_t round_ = 0;
  std::size_t cycle_steps_left_ = most_cycle_steps;
  bool again_ = false;                      ///< this is not the first round of the query
  bool met_open_ = false, changed_ = false; ///< in this round
};

} // namespace director::analysis
