// Header: compiler/graph/topmost.hpp. Test: tests/compiler/graph/topmost_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/graph/topmost.hpp"

namespace director::compiler {

namespace {

bool passes(const std::vector<std::optional<Node>>& dominators, Node node, Node other) {
  for (std::optional<Node> above = dominators[node]; above; above = dominators[*above]) {
    if (*above == other) return true;
  }
  return false;
}

} // namespace

std::vector<GroupId> Topmost::of(GroupId first, GroupId second, const std::vector<bool>& groups) {
  const auto &of_first = dominators(first), &of_second = dominators(second);
  const auto comes_with_another = [&](Node node) {
    for (std::optional<Node> above = of_first[node]; above; above = of_first[*above]) {
      if (groups[*above] && passes(of_second, node, *above)) return true;
    }
    return false;
  };
  std::vector<GroupId> out;
  for (Node node = 0; node < groups.size(); ++node) {
    if (groups[node] && !comes_with_another(node)) out.push_back(GroupId{node});
  }
  return out;
}

const std::vector<std::optional<Node>>& Topmost::dominators(GroupId task) {
  std::vector<std::optional<Node>>& out = dominators_[task];
  if (out.empty()) out = immediate_dominators(graph_.claims, task.value);
  return out;
}

} // namespace director::compiler
