#pragma once
// SPDX-License-Identifier: MIT
// What a complete exploration reached, in more detail than it reports: pushes, packs that were granted whole, the
// values of states, providers that ran below a request.

#include "compiler/explore/search/search.hpp"

#include <array>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

namespace director::property {

/// A pack with two or more mandatory members, which are granted all or none.
struct WholePack {
  compiler::ProviderId provider{};
  std::size_t pack = 0; ///< its place among those of the provider
  std::vector<compiler::EdgeId> members;
};

std::vector<WholePack> whole_packs(const compiler::Model& model);

/// While this provider ran, a task was granted, by the edge `by`, through its request `edge`.
struct GrantedBelow {
  compiler::ProviderId provider{};
  compiler::EdgeId edge{}, by{};
  auto operator<=>(const GrantedBelow&) const = default;
};

class Reached {
public:
  explicit Reached(const compiler::Ground& ground);
  /// Notes the state after a micro-step.
  void look(const compiler::Machine& machine);
  /// Explores by itself, with at most this number of states; false: it is not complete.
  bool find_changes(std::size_t bound);
  /// Takes the notes of the search; false: it is not complete.
  bool take(const compiler::Searched& searched);

  std::vector<bool> ran;                ///< provider
  std::vector<bool> requested, granted; ///< edge
  std::vector<bool> whole;              ///< row of whole_packs()
  std::set<std::pair<compiler::ProviderId, compiler::ConditionId>> pushed;
  std::set<std::pair<compiler::ProviderId, compiler::ConditionId>>
      pushed_to_effect;                       ///< the provider ran while the task waited
  std::vector<std::set<std::int32_t>> values; ///< state
  std::set<GrantedBelow> granted_below;
  /// A group that is granted, neither it nor a need of it held by a push, and the values of all states then.
  std::set<std::pair<compiler::GroupId, std::vector<std::int32_t>>> granted_in;
  /// After find_changes(): the values of all states, and those after the next micro-step.
  std::set<std::pair<std::vector<std::int32_t>, std::vector<std::int32_t>>> changes;

private:
  void look_below(const director::Engine& engine);

  const compiler::Ground& ground_;
  std::vector<WholePack> packs_;
  std::unordered_set<std::uint64_t> seen_;
  std::vector<std::uint32_t> now_;
};

} // namespace director::property
