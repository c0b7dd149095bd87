// SPDX-License-Identifier: MIT
#include "tests/property/document.hpp"

#include <catch2/catch.hpp>

namespace {

using director::property::Node;

TEST_CASE("a document is written in block style down to a depth and in flow style below it") {
  Node document;
  document.add("behaviour", "b");
  Node& groups = document.add("groups", {});
  Node& walk = groups.add("Walk", {});
  walk.add("when", Node::list({"S == v0|v1"}));
  walk.add("tasks", {}).add("Legs", {}).add("priority", "10");
  CHECK(to_yaml(document, 3) == "behaviour: b\n"
                                "groups:\n"
                                "  Walk:\n"
                                "    when: [S == v0|v1]\n"
                                "    tasks: {Legs: {priority: 10}}\n");
}

} // namespace
