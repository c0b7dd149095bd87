// SPDX-License-Identifier: MIT
#include "compiler/graph/graph.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;

TEST_CASE("a graph has tasks, needs, promises, cycles and gates") {
  const auto compiled = tests::compile(R"(behaviour: test
language: 1
states: {Stability: {values: [moving, standing], initial: moving}}
roots: {Play: {priority: 10}, Report: {priority: 20}}
groups:
  Play: {tasks: [Walk, Kick]}
  Walk:
    providers:
      - {name: walking, needs: [Legs], tasks: [Legs], sets: [Stability == moving]}
      - {name: halting, needs: [Legs], causing: [Stability == standing]}
  Kick: {when: [Stability == standing], needs: [Legs], tasks: {Report: {optional: true}}}
  Report: {tasks: {Kick: {optional: true}}}
  Legs: {}
  Idle: {tasks: [Legs]}
)");
  CHECK(print_graph(compiled.model, compiler::make_graph(compiled.model)) == R"(tasks
  Play -> Walk, Kick
  Walk -> Legs
  Kick -> Report
  Report -> Kick
  Idle -> Legs
needs
  Walk -> Legs
  Kick -> Legs
causing
  Walk.halting (Stability == standing) -> Kick (Stability == standing)
cycle of tasks: Kick, Report
order: Idle, Play, Kick, Report, Walk, Legs
gates
  Walk: only by Play
  Legs: only by Walk
  Idle: nothing leads to it
)");
}

TEST_CASE("a behaviour without groups has an empty graph") {
  const auto compiled = tests::compile("behaviour: test\nlanguage: 1\nroots: []\n");
  CHECK(print_graph(compiled.model, compiler::make_graph(compiled.model)) == "tasks\nneeds\ncausing\norder: \ngates\n");
}

} // namespace
