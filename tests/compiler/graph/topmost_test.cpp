// SPDX-License-Identifier: MIT
#include "compiler/graph/topmost.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <catch2/catch.hpp>

namespace director::tests {

namespace {

/// Of all groups that both lead to.
std::vector<std::string> topmost(const std::string& groups, const std::string& first, const std::string& second) {
  const Compiled c =
      compile("behaviour: test\nlanguage: 1\nroots: [" + first + ", " + second + "]\ngroups: {" + groups + "}\n");
  const compiler::Graph graph = compiler::make_graph(c.model);
  const compiler::GroupId one = *c.model.find_group(first), other = *c.model.find_group(second);
  std::vector<bool> both = compiler::led_to(graph, one);
  const std::vector<bool> others = compiler::led_to(graph, other);
  for (std::size_t i = 0; i < both.size(); ++i) both[i] = both[i] && others[i];
  std::vector<std::string> out;
  for (const compiler::GroupId id : compiler::Topmost(graph).of(one, other, both))
    out.push_back(c.model.groups[id].name.value);
  return out;
}

using Names = std::vector<std::string>;

} // namespace

TEST_CASE("a group that both reach only past another common one comes with that") {
  CHECK(topmost("Fetch: {tasks: [Drive]}, Dock: {tasks: [Drive]}, Drive: {tasks: [Wheels]}, Wheels: {tasks: [Motor]}, "
                "Motor: {}",
                "Fetch", "Dock") == Names{"Drive"});
}

TEST_CASE("a group that one of the two reaches past another common one, too, comes alone") {
  const std::string rest = "Drive: {tasks: [Wheels]}, Grasp: {tasks: [Wheels]}, Wheels: {tasks: [Motor]}, Motor: {}";
  for (const char* const tasks : {"Fetch: {tasks: [Drive, Grasp]}, Dock: {tasks: [Drive]}, ",
                                  "Dock: {tasks: [Drive, Grasp]}, Fetch: {tasks: [Drive]}, "})
    CHECK(topmost(tasks + rest, "Fetch", "Dock") == Names{"Drive", "Wheels"});
}

TEST_CASE("of groups that request each other none is left without the other") {
  CHECK(topmost("Search: {tasks: [Track]}, Track: {tasks: {Search: {optional: true}}}", "Search", "Track") ==
        Names{"Search", "Track"});
}

} // namespace director::tests
