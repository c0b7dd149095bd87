#include "compiler/checks/analysis/facts/witness.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::checks;

const char* const text = R"(behaviour: test
language: 1
states:
  Pose: {values: [moving, standing, lying]}
  Arm: {values: [folded, out], initial: folded}
roots: {Walk: {priority: 10}, Play: {priority: 20}}
groups:
  Walk:
    stop: {sets: [Arm == out]}
    providers:
      - {name: walking, needs: [Legs]}
      - {name: halting, needs: [Legs], causing: [Pose == standing]}
  Play: {tasks: [Kick]}
  Kick: {when: [Pose == standing, Arm == out], needs: [Legs]}
  Legs: {}
  Rest: {when: [Pose == lying]}
)";

std::string witness(const Goal& goal) {
  const auto compiled = tests::compile(text);
  const Facts facts = find_facts(compiled.model, make_graph(compiled.model));
  const auto steps = find_witness(compiled.model, facts, goal);
  if (!steps) return "never";
  std::string out;
  for (const dsl::Note& step : *steps)
    out += std::to_string(compiled.sources[step.span.file].place(step.span.begin).line) + ": " + step.message + "\n";
  return out;
}

TEST_CASE("what leads to a task is told from the roots on, each thing once") {
  const auto compiled = tests::compile(text);
  CHECK(witness(compiled.group("Kick")) == R"(6: the program may request `Play`
13: `Play` may run
13: `Play` may request `Kick`
6: the program may request `Walk`
12: `Walk.halting` may run, pushed
12: `Walk.halting` may cause `Pose == standing`
11: `Walk.walking` may run
9: the stop handler of `Walk` may set `Arm == out`
14: `Kick` may run
)");
}

TEST_CASE("what leads to a value, and what never comes about") {
  const auto compiled = tests::compile(text);
  const StateId pose = *compiled.model.find_state("Pose"), arm = *compiled.model.find_state("Arm");
  CHECK(witness(StateValue{arm, 0}) == "5: `Arm` is folded at the start\n");
  CHECK(witness(StateValue{pose, 2}) == "never");
  CHECK(witness(compiled.group("Rest")) == "never");
  CHECK(witness(compiled.provider("Walk.walking")) ==
        "6: the program may request `Walk`\n11: `Walk.walking` may run\n");
}

} // namespace
