#pragma once
// SPDX-License-Identifier: MIT
// A unit is tried at the place of its first member, so a member may go before what its own rank is behind: with which
// other members, and whether always. Source: semantics.md 4.4.

#include "compiler/analysis/ranks/contention.hpp"
#include "compiler/graph/algorithms.hpp"
#include "compiler/model/model.hpp"

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace director::compiler {

/// The entry for the edge; null: none.
const Task* entry_of(const Pack& pack, EdgeId edge);

/// A member at the first place.
struct Leader {
  EdgeId edge{};
  std::int32_t priority = 0;
  bool if_older = false; ///< its priority is that of the rival: the older request of the two goes first
  auto operator<=>(const Leader&) const = default;
};

struct Leaders {
  std::vector<Leader> all; ///< by edge and level; empty: nothing of this kind
  bool always = false;     ///< in every request one of them is requested too, and goes before the rival
};

/// For one side of a decision, which is behind by rank or equal: the members that bring it forward if it is requested
/// as a member of their unit, and the other side is apart.
class LeaderFinder {
public:
  explicit LeaderFinder(const Model& model) : model_(model) {}
  const Leaders& of(const analysis::Decision& decision, bool first);

private:
  void look(const Pack& pack, EdgeId member, const analysis::SideRank& rank, EdgeId rival,
            const analysis::SideRank& rivals, Leaders& out) const;
  Leaders find(const analysis::Decision& decision, bool first) const;

  const Model& model_;
  std::map<std::pair<analysis::Decision, bool>, Leaders> known_;
};

/// How one group comes to hold another.
class Ways {
public:
  explicit Ways(const Model& model);
  /// By needs alone, with its own grant; a group needs itself.
  bool needs(GroupId from, GroupId to) { return paths(from).needs[to.value]; }
  /// By some task that it, or what it holds by then, requests.
  bool asks(GroupId from, GroupId to) { return paths(from).asks[to.value]; }

private:
  struct Paths {
    std::vector<bool> needs, asks;
  };
  const Paths& paths(GroupId from);

  const Model& model_;
  Arrows needs_, all_; ///< from group to group
  IdTable<GroupId, std::optional<Paths>> known_;
};

} // namespace director::compiler
