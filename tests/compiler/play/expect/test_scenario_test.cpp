// SPDX-License-Identifier: MIT
#include "compiler/play/expect/test_scenario.hpp"
#include "tests/compiler/support/played.hpp"

using namespace director::compiler;
using director::tests::load_scenario;
using director::tests::LoadedScenario;

namespace {

const char* const pair = R"(behaviour: pair
language: 1
roots: [A]
groups: {A: {tasks: [B]}, B: {}}
)";

struct Tested {
  bool holds;
  std::string text;
};

Tested test(const std::string& text) {
  const LoadedScenario loaded = load_scenario(pair, text);
  INFO(loaded.findings);
  REQUIRE(loaded.findings.empty());
  const ScenarioResult result = test_scenario(loaded.scenario, loaded.behaviour.model, loaded.lowered);
  return {result.holds(), render(result, loaded.behaviour.sources)};
}

} // namespace

TEST_CASE("a scenario holds where each step with an expectation happens so") {
  const Tested tested = test(R"(
steps:
  - request: A
    expect: |
      # first the one above

      run A new_task
        run B new_task
  - request: A
  - cancel: A
    expect: ""
)");
  CHECK(tested.holds);
  CHECK(tested.text == "");
}

TEST_CASE("each step that happens otherwise is shown with what differs") {
  const Tested tested = test(R"(
steps:
  - request: A
    expect: |
      run A new_task
      start B
  - cancel: A
    expect: |
      stop A
)");
  CHECK(!tested.holds);
  CHECK(tested.text == R"(test.scenario.yaml:5:13: step 1: request A
    --- expected
    +++ happened
    @@ -1,2 +1,2 @@
     run A new_task
    -start B
    +run B new_task
test.scenario.yaml:9:13: step 2: cancel A
    --- expected
    +++ happened
    @@ -1 +0,0 @@
    -stop A
)");
}

TEST_CASE("a scenario that does not come to rest fails, whatever it expects") {
  const Tested tested = test(R"(
script: {B: {done: true}}
steps:
  - request: A
  - cancel: A
    expect: ""
)");
  CHECK(!tested.holds);
  const std::string begin = R"(test.scenario.yaml:5:5: step 1: request A
    it did not come to rest within 10000 micro-steps: A, B run again and again; a case with `reason: subtask_done` in the script says what A answers when one of its tasks is done
    run A new_task
    run B new_task
    done B
)";
  CHECK(tested.text.substr(0, begin.size()) == begin);
  CHECK(tested.text.ends_with("\n    ... and 14969 more lines\n"));
}

TEST_CASE("of a scenario that does not come to rest though its script answers what is done, only the round is told") {
  const Tested tested = test(R"(
script: {B: {done: true}, A: [{reason: subtask_done, tasks: [B]}, {tasks: [B]}]}
steps:
  - request: A
)");
  CHECK(!tested.holds);
  CHECK(tested.text.starts_with("test.scenario.yaml:5:5: step 1: request A\n"
                                "    it did not come to rest within 10000 micro-steps: A, B run again and again\n"));
}

TEST_CASE("a scenario that advances time beyond the limit fails") {
  const LoadedScenario loaded = load_scenario(R"(behaviour: metronome
language: 1
roots: [A]
groups:
  A: {every: 1 us}
)",
                                              R"(
script: {A: {continue: true}}
steps:
  - request: A
  - advance: 3 us
  - advance: 100000000 min
)");
  PlayOptions options;
  options.most_stops = 3;
  const ScenarioResult result = test_scenario(loaded.scenario, loaded.behaviour.model, loaded.lowered, options);
  CHECK(!result.holds());
  CHECK(render(result, loaded.behaviour.sources) == R"(test.scenario.yaml:7:5: step 3: advance 100000000 min
    something is due at more than 1000000 times within it; advance by less
    run A trigger
    run A trigger
    run A trigger
    budget_exhausted
)");
}

TEST_CASE("if a body may not do what its script requires, the steps before are compared and no other") {
  const LoadedScenario loaded = load_scenario(R"(behaviour: refused
language: 1
states: {S: {values: [a, b]}}
roots: [A]
groups:
  A:
    providers:
      - {name: one, when: [S == a], causing: [S == b]}
      - {name: two}
)",
                                              R"(
script: {A: {set: {S: b}}}
steps:
  - request: A
    expect: run A.two new_task
  - cancel: A
    expect: stop A
)");
  const ScenarioResult result = test_scenario(loaded.scenario, loaded.behaviour.model, loaded.lowered);
  CHECK(!result.holds());
  CHECK(result.mismatches.empty());
  REQUIRE(result.played.refused);
  CHECK(result.played.refused->message == "`A.two` sets `S` to `b`, which it does not declare");
}
