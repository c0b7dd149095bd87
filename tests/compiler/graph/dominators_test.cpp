// SPDX-License-Identifier: MIT
#include "compiler/graph/dominators.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director::compiler;

TEST_CASE("what every path passes is above") {
  // 0 leads to 1 and 2, both to 3, that to 4; nothing leads to 5, which leads to 4.
  const DominatorTree tree({{1, 2}, {3}, {3}, {4}, {}, {4}}, 0);
  CHECK(tree.is_below(4, 3));
  CHECK(tree.is_below(4, 0));
  CHECK(tree.is_below(3, 3));
  CHECK_FALSE(tree.is_below(3, 4));
  CHECK_FALSE(tree.is_below(3, 1));
  CHECK_FALSE(tree.is_below(4, 2));
  CHECK_FALSE(tree.is_below(4, 5));
  CHECK_FALSE(tree.is_below(5, 0));
  CHECK_FALSE(tree.is_below(5, 5));
}

TEST_CASE("another way round a cycle changes nothing") {
  const DominatorTree tree({{1}, {2}, {1, 3}, {}}, 0);
  CHECK(tree.is_below(3, 2));
  CHECK(tree.is_below(2, 1));
  CHECK_FALSE(tree.is_below(1, 2));
}

TEST_CASE("it takes a chain of any length") {
  Arrows arrows(100'000);
  for (Node node = 0; node + 1 < arrows.size(); ++node) arrows[node].push_back(node + 1);
  const DominatorTree tree(arrows, 0);
  CHECK(tree.is_below(99'999, 1));
  CHECK_FALSE(tree.is_below(1, 99'999));
}

} // namespace
