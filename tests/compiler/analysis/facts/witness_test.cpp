// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/witness.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

const char* const witnessed = R"(states:
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

std::string witness(const tests::Analysed& test, const Goal& goal) {
  const auto steps = find_witness(test.model, test.facts, goal);
  if (!steps) return "never";
  std::string out;
  for (const dsl::Note& step : *steps)
    out +=
        std::to_string(test.compiled.sources[step.span.file].place(step.span.begin).line) + ": " + step.message + "\n";
  return out;
}

TEST_CASE("the steps that lead to a task are listed from the roots on, each once") {
  const tests::Analysed test(witnessed);
  CHECK(witness(test, test.group("Kick")) == R"(6: the program may request `Play`
13: `Play` may run
13: `Play` may request `Kick`
6: the program may request `Walk`
12: `Walk.halting` may run, pushed while `Kick` waits for `Pose == standing`
12: `Walk.halting` may cause `Pose == standing`
11: `Walk.walking` may run
9: the stop handler of `Walk` may set `Arm == out`
14: `Kick` may run
)");
}

TEST_CASE("what leads to a value, and what never comes about") {
  const tests::Analysed test(witnessed);
  const StateId pose = test.state("Pose"), arm = test.state("Arm");
  CHECK(witness(test, StateValue{arm, 0}) == "5: `Arm` is folded at the start\n");
  CHECK(witness(test, StateValue{pose, 2}) == "never");
  CHECK(witness(test, test.group("Rest")) == "never");
  CHECK(witness(test, test.provider("Walk.walking")) ==
        "6: the program may request `Walk`\n11: `Walk.walking` may run\n");
}

} // namespace
