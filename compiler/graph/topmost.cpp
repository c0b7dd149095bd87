// Header: compiler/graph/topmost.hpp. Test: tests/compiler/graph/topmost_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/graph/topmost.hpp"

#include <algorithm>

namespace director::compiler {

std::optional<Node> Topmost::above(const Dominators& dominators, Node node) {
  const auto at = std::lower_bound(dominators.begin(), dominators.end(), std::pair(node, Node{0}));
  return at == dominators.end() || at->first != node ? std::nullopt : std::optional(at->second);
}

bool Topmost::passes(const Dominators& dominators, Node node, Node other) {
  for (std::optional<Node> each = above(dominators, node); each; each = above(dominators, *each)) {
    if (*each == other) return true;
  }
  return false;
}

std::vector<GroupId> Topmost::of(GroupId first, GroupId second, const std::vector<bool>& groups) {
  const Dominators &of_first = dominators(first), &of_second = dominators(second);
  const auto comes_with_another = [&](Node node) {
    for (std::optional<Node> each = above(of_first, node); each; each = above(of_first, *each)) {
      if (groups[*each] && passes(of_second, node, *each)) return true;
    }
    return false;
  };
  std::vector<GroupId> out;
  for (Node node = 0; node < groups.size(); ++node) {
    if (groups[node] && !comes_with_another(node)) out.push_back(GroupId{node});
  }
  return out;
}

const Topmost::Dominators& Topmost::dominators(GroupId task) {
  const auto [at, fresh] = dominators_.try_emplace(task);
  if (!fresh) return at->second;
  const std::vector<std::optional<Node>> all = immediate_dominators(graph_.claims, task.value);
  for (Node node = 0; node < all.size(); ++node) {
    if (all[node]) at->second.emplace_back(node, *all[node]);
  }
  return at->second;
}

} // namespace director::compiler
