#pragma once
// SPDX-License-Identifier: MIT
// For the decisions of a page: with which other members of its unit a task may go before what its own rank is behind,
// and whether always (analysis/chains/unit_places.hpp).

#include "compiler/analysis/chains/unit_places.hpp"
#include "compiler/analysis/ranks/contention.hpp"
#include "compiler/graph/algorithms.hpp"
#include "compiler/model/model.hpp"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace director::compiler {

/// The entry for the edge; null: none.
const Task* entry_of(const Pack& pack, EdgeId edge);

using analysis::Leader;
using analysis::Leaders;

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
