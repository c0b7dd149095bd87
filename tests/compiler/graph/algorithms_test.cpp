// SPDX-License-Identifier: MIT
#include "compiler/graph/algorithms.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director::compiler;
using Nodes = std::vector<Node>;

TEST_CASE("cycles are the components that a path leads around in") {
  CHECK(cycles({{1}, {2}, {0}, {0}, {4}, {}}) == std::vector<Nodes>{{0, 1, 2}, {4}});
  CHECK(cycles({{1, 2}, {0}, {3}, {2}}) == std::vector<Nodes>{{0, 1}, {2, 3}}); // in order of their nodes
  CHECK(cycles({{1}, {}}).empty());
  CHECK(cycles({}).empty());
}

TEST_CASE("in topological order requesters come before what they request") {
  CHECK(topological_order({{}, {0}, {1}}) == Nodes{2, 1, 0});
  CHECK(topological_order({{1, 2}, {3}, {3}, {}}).front() == 0);
  CHECK(topological_order({{1, 2}, {3}, {3}, {}}).back() == 3);
  CHECK(topological_order({{1}, {2}, {1}}) == Nodes{0, 1, 2});
}

TEST_CASE("a gate is what every path passes") {
  const auto gates = immediate_dominators({{1, 2}, {3}, {3}, {4}, {}, {4}}, 0);
  CHECK_FALSE(gates[0]);
  CHECK(gates[1] == Node{0});
  CHECK(gates[3] == Node{0});
  CHECK(gates[4] == Node{3});
  CHECK_FALSE(gates[5]);
}

TEST_CASE("a node reaches itself only around a cycle") {
  CHECK(reachable({{1}, {}}, 0) == std::vector<bool>{false, true});
  CHECK(reachable({{1}, {0}}, 0) == std::vector<bool>{true, true});
  CHECK(reachable({{1}, {}, {3}, {}, {3}}, std::vector<Node>{0, 2}) ==
        std::vector<bool>{false, true, false, true, false});
}

TEST_CASE("a shortest path has both of its ends") {
  CHECK(shortest_path({{1, 2}, {3}, {3}, {}}, 0, 3) == Nodes{0, 1, 3});
  CHECK(shortest_path({{1}, {2}, {0}}, 1, 1) == Nodes{1, 2, 0, 1});
  CHECK(shortest_path({{1}, {}}, 1, 0).empty());
  const std::vector<bool> without_1{true, false, true, true};
  CHECK(shortest_path({{1, 2}, {3}, {3}, {}}, 0, 3, &without_1) == Nodes{0, 2, 3});
}

TEST_CASE("a chain of a hundred thousand is no danger to the stack") {
  Arrows chain(100'000);
  for (Node i = 0; i + 1 < chain.size(); ++i) chain[i].push_back(i + 1);
  CHECK(cycles(chain).empty());
  CHECK(topological_order(chain).front() == 0);
  CHECK(immediate_dominators(chain, 0)[99'999] == Node{99'998});
  CHECK(shortest_path(chain, 0, 99'999).size() == 100'000);
}

} // namespace
