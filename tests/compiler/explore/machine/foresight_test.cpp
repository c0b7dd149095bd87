// SPDX-License-Identifier: MIT
// Micro-steps that are predicted to end alike do: a search that takes every micro-step finds the same. On random
// behaviours: tests/property/explore_test.cpp.
#include "compiler/explore/machine/foresight.hpp"
#include "tests/compiler/explore/explored.hpp"
#include "tests/support/same_searches.hpp"

using namespace director::compiler;
using director::tests::search_both_ways;

namespace {

constexpr std::size_t few_states = 20'000;

} // namespace

TEST_CASE("a search that takes every micro-step finds what one finds that foresees some") {
  const std::string behaviour = GENERATE(as<std::string>{},
                                         R"(
states: {Pose: {values: [moving, standing], external: true}}
)" + director::tests::walker_groups,
                                         R"(
states:
  S: {values: [x, y, z], initial: x, external: true}
  T: {values: [a, b], initial: a, of: Low}
roots: {A: {priority: 20}, B: {priority: 10}}
groups:
  A:
    sets: [S == x, S == y]
    packs:
      both: {Low: {priority: 1}, Mid: {priority: 1}}
      low: {Low: {priority: 1}}
      mid: {Mid: {priority: 2, optional: true}}
  B: {when: [S != z], needs: [Low], causing: [S == y], tasks: [Low]}
  Low: {start: {sets: [T == a]}, stop: {sets: [S == x, S == z]}, sets: [T == b]}
  Mid: {when: [T == b], tasks: [Low]}
)",
                                         R"(
states:
  Pose: {values: [moving, standing], initial: moving, external: true}
  Level: {range: [0, 9], initial: 5, external: true}
roots: {Goal: {priority: 5}, Other: {priority: 5}}
groups:
  Goal: {packs: {all: {Walk: {priority: 1}, Kick: {priority: 2}, Look: {priority: 2}}, kick: {Kick: {priority: 2}}}}
  Other: {tasks: [Look, Walk]}
  Walk:
    providers:
      - {name: walking, sets: [Pose == moving], needs: [Legs]}
      - {name: halting, causing: [Pose == standing], needs: [Legs], tasks: [Legs]}
  Kick: {when: [Pose == standing, Level > 3], needs: [Legs], tasks: [Legs]}
  Look: {providers: [{name: near, when: [Level > 3]}, {name: far, tasks: [Legs]}]}
  Legs: {}
)");
  const auto compiled = director::tests::compile("behaviour: b\nlanguage: 1\n" + behaviour);
  const Ground ground(compiled.model);
  SearchOptions options;
  options.bound = few_states;
  options.threads = 1;
  options.breadth = GENERATE(Breadth::all, Breadth::lean);
  CHECK(search_both_ways(ground, options).empty());
}
