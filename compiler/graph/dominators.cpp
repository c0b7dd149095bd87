// Header: compiler/graph/dominators.hpp. Test: tests/compiler/graph/dominators_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/graph/dominators.hpp"

namespace director::compiler {

DominatorTree::DominatorTree(const Arrows& arrows, Node start) : below_(arrows.size()) {
  Arrows children(arrows.size());
  const auto last = immediate_dominators(arrows, start);
  for (Node node = 0; node < last.size(); ++node) {
    if (last[node]) children[*last[node]].push_back(node);
  }
  std::vector<std::pair<Node, std::size_t>> open{{start, 0}}; // with the number of visited children
  Node count = 1;
  while (!open.empty()) {
    const Node node = open.back().first;
    if (open.back().second == children[node].size()) {
      below_[node].second = count;
      open.pop_back();
      continue;
    }
    const Node child = children[node][open.back().second++];
    below_[child].first = count++;
    open.emplace_back(child, 0);
  }
}

bool DominatorTree::is_below(Node node, Node other) const {
  const auto here = below_[node], there = below_[other];
  return here.first != here.second && there.first <= here.first && here.first < there.second;
}

} // namespace director::compiler
