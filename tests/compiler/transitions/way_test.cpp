// SPDX-License-Identifier: MIT
#include "compiler/transitions/way.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <catch2/catch.hpp>

namespace director::tests {

namespace {

using namespace compiler::transitions;

/// `Play.running > Walk.slow`, followed by the values from outside.
std::vector<std::string> ways(const std::string& behaviour, const std::string& target) {
  const Compiled compiled = compile("behaviour: test\nlanguage: 1\n" + behaviour);
  std::vector<std::string> out;
  for (const Way& way : find_ways(compiled.model, compiled.group(target))) {
    std::string text;
    for (const Link& link : way.links) text += compiled.model.full_name(link.provider) + " > ";
    text += compiled.model.full_name(way.runs);
    const std::optional<Outside> outside = outside_for(compiled.model, way, Assume::nothing);
    if (!outside) text += ": never";
    if (outside) {
      for (const auto& [state, value] : outside->values)
        text += ": " + compiled.model.states[state].name.value + " " + compiled.model.states[state].value_text(value);
    }
    out.push_back(text);
  }
  return out;
}

} // namespace

TEST_CASE("the shortest chain of requesters comes first, of equal ones that which was declared first") {
  CHECK(ways(R"(roots: [Long, Short, Other]
groups:
  Long: {tasks: [Middle]}
  Middle: {tasks: [Walk]}
  Short: {tasks: [Walk]}
  Other: {tasks: [Walk]}
  Walk: {}
)",
             "Walk") == std::vector<std::string>{"Short > Walk", "Long > Middle > Walk", "Other > Walk"});
}

TEST_CASE("a preferred provider that does not lead there is kept from running by a value that it refuses") {
  CHECK(ways(R"(states: {Ball: {values: [near, far, lost], initial: near, external: true}}
roots: [Play]
groups:
  Play:
    providers:
      - {name: kicking, when: [Ball == near], tasks: [Kick]}
      - {name: running, tasks: [Walk]}
  Kick: {}
  Walk: {}
)",
             "Walk") == std::vector<std::string>{"Play.running > Walk: Ball far"});
}

TEST_CASE("conditions on the way that exclude each other leave no values") {
  CHECK(ways(R"(states: {Ball: {values: [near, far], initial: near, external: true}}
roots: [Play]
groups:
  Play: {when: [Ball == near], tasks: [Walk]}
  Walk: {when: [Ball == far]}
)",
             "Walk") == std::vector<std::string>{"Play > Walk: never"});
}

TEST_CASE("no chain leads to what nothing requests") {
  CHECK(ways("roots: [Walk]\ngroups: {Walk: {needs: [Legs]}, Legs: {}}\n", "Legs").empty());
}

} // namespace director::tests
