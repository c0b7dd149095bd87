#pragma once
// SPDX-License-Identifier: MIT
// Finds what every path from a start passes, with queries in constant time.

#include "compiler/graph/algorithms.hpp"

#include <utility>
#include <vector>

namespace director::compiler {

class DominatorTree {
public:
  DominatorTree(const Arrows& arrows, Node start);

  /// Whether every path to the node passes the other one, or they are the same; false if one of them is unreachable.
  bool is_below(Node node, Node other) const;

private:
  /// Preorder numbers of each node's subtree, itself first; empty for unreachable nodes.
  std::vector<std::pair<Node, Node>> below_;
};

} // namespace director::compiler
