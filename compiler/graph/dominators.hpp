#pragma once
// SPDX-License-Identifier: MIT
// What every path from a start passes, asked in constant time.

#include "compiler/graph/algorithms.hpp"

#include <utility>
#include <vector>

namespace director::compiler {

class DominatorTree {
public:
  DominatorTree(const Arrows& arrows, Node start);

  /// Every path to the node passes the other one, or they are the same; false where no path leads to one of them.
  bool is_below(Node node, Node other) const;

private:
  /// The numbers of what is below each, itself the first; the same twice where no path leads to it.
  std::vector<std::pair<Node, Node>> below_;
};

} // namespace director::compiler
