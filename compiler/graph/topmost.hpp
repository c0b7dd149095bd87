#pragma once
// SPDX-License-Identifier: MIT
// Of the groups that two tasks may contend for, finds those that have to be named: the others come with them.

#include "compiler/graph/graph.hpp"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace director::compiler {

/// Keeps the dominators of each task between queries. The graph has to outlive it.
class Topmost {
public:
  explicit Topmost(const Graph& graph) : graph_(graph) {}

  /// Of these groups, by number, those for which there is no other one of them that both tasks always pass on the way
  /// there. Never empty if there are groups that both lead to, since dominators form no cycle.
  std::vector<GroupId> of(GroupId first, GroupId second, const std::vector<bool>& groups);

private:
  /// The closest dominator of each group that the task leads to, by group: most tasks lead to few groups.
  using Dominators = std::vector<std::pair<Node, Node>>;

  static std::optional<Node> above(const Dominators& dominators, Node node);
  static bool passes(const Dominators& dominators, Node node, Node other);
  const Dominators& dominators(GroupId task);

  const Graph& graph_;
  std::map<GroupId, Dominators> dominators_;
};

} // namespace director::compiler
