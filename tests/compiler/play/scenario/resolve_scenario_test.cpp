// SPDX-License-Identifier: MIT
#include "tests/compiler/support/played.hpp"
#include "tests/support/golden.hpp"

using director::tests::check_golden;
using director::tests::load_scenario;

namespace {

const char* const robot = R"(behaviour: robot
language: 1
states:
  Pose: {values: [moving, standing], initial: moving}
  Charge: {range: [0, 100], external: true}
  Mode: {values: [idle, busy], external: true}
triggers: [Bell]
roots:
  Walk: {priority: {calm: 10, urgent: 80}}
  Kick: {priority: 20}
groups:
  Walk:
    start: true
    stop: {sets: [Pose == moving]}
    providers:
      - {name: walking, sets: [Mode], tasks: {Legs: {priority: {slow: 1, fast: 2}}}, uses: [Legs]}
      - {name: halting, causing: [Pose == standing], tasks: [Legs]}
  Kick:
    when: [Pose == standing]
    packs: {hard: {Legs: {}, Arms: {optional: true}}, soft: {Legs: {}}}
    triggers: [Bell]
  Legs: {}
  Arms: {}
)";

std::string findings(const std::string& text) { return load_scenario(robot, text).findings; }

} // namespace

TEST_CASE("a scenario that is right has no findings") {
  CHECK(findings(R"(
given: {Pose: standing, Charge: 3}
script:
  Walk: {set: {Mode: busy}, tasks: [Legs: {data: {x: 1}, keep: true}]}
  Walk.halting: {reason: pushed, set: {Pose: standing}}
  Walk.start: {data: 3, run: 1}
  Walk.stop: {set: {Pose: moving}}
  Kick: [{trigger: Bell, pack: hard, with: [Legs: {data: 2}]}, {done: true, wait: 10 ms}]
  Arms.default: {continue: true}
steps:
  - request: {Walk: {level: urgent, data: 1}, Kick: {}}
  - cancel: Walk
  - set: {Charge: 3, Mode: idle}
  - trigger: Bell
  - inputs: [{disable: Walk.halting}, {enable: Kick.default}]
  - advance: 10 ms
)") == "");
}

TEST_CASE("a case about a group that its provider cannot see says what to add") {
  CHECK(findings("script:\n  Legs: {uses: {Arms: done}, done: true}\n")
            .find("`Legs` does not see `Arms`: it has no `uses` [undefined_name]") != std::string::npos);
  CHECK(findings("script:\n  Legs: {uses: {Arms: done}, done: true}\n").find("help: write `uses: [Arms]` at `Legs`") !=
        std::string::npos);
}

TEST_CASE("unknown names are found wherever they are, with the nearest known one", "[golden]") {
  check_golden("tests/compiler/play/scenario/golden/unknown_names.txt", findings(R"(
given: {Posse: standing}
script:
  Wlak: {done: true}
  Walk.waking: {done: true}
  Arms.start: {}
  Legs: {trigger: Belt, tasks: [Arms]}
  Kick: {pack: hart}
  Walk.halting: {pack: hard}
  Walk.walking: [{uses: {Arms: done}}, {tasks: [Legs: {level: fat}]}, {tasks: [Feet]}]
steps:
  - request: Leg
  - request: {Walk: {level: urgend}}
  - cancel: Legs
  - set: {Charg: 3}
  - trigger: Bel
  - disable: Kick.halting
  - enable: Wlak.halting
)"));
}

TEST_CASE("what a body, a handler or a step may not set is found before anything runs", "[golden]") {
  check_golden("tests/compiler/play/scenario/golden/undeclared_sets.txt", findings(R"(
given: {Charge: 101}
script:
  Walk.walking: {set: {Pose: standing}}
  Walk.start: {set: {Pose: moving}}
  Walk.stop: {set: {Pose: standing}}
  Arms: {set: {Mode: bussy}}
steps:
  - set: {Pose: standing, Charge: low}
)"));
}

TEST_CASE("a provider with packs names one of them", "[golden]") {
  check_golden("tests/compiler/play/scenario/golden/missing_packs.txt", findings(R"(
script:
  Kick: [{tasks: [Legs]}, {wait: 10 ms}, {pack: soft, with: [Arms]}]
)"));
}

TEST_CASE("a case leaves out only optional entries of its pack, of which it says no more", "[golden]") {
  check_golden("tests/compiler/play/scenario/golden/left_out.txt", findings(R"(
script:
  Kick:
    - {run: 1, pack: hard, without: [Arms]}
    - {run: 2, pack: hard, without: [Legs]}
    - {run: 3, pack: soft, without: [Legs, Arms]}
    - {run: 4, pack: hard, without: [Arm]}
    - {run: 5, pack: hard, without: [Arms, Arms]}
    - {pack: hard, with: [Arms: {data: 1}], without: [Arms]}
)"));
}

TEST_CASE("a case requests no task twice, other than one of its pack at another level") {
  CHECK(findings("script: {Kick: [{pack: hard, with: [Legs]}], Walk: [{tasks: [Legs, Legs]}]}\n") ==
        R"(test.scenario.yaml:2:68: error: `Legs` is listed twice [redefined_name]
    2 | script: {Kick: [{pack: hard, with: [Legs]}], Walk: [{tasks: [Legs, Legs]}]}
      |                                                                    ^~~~
test.scenario.yaml:2:62: note: it is listed here first
    2 | script: {Kick: [{pack: hard, with: [Legs]}], Walk: [{tasks: [Legs, Legs]}]}
      |                                                              ^~~~
  help: remove one of them
1 error
)");
}

TEST_CASE("a handler of the group is among the names that may be meant") {
  CHECK(findings("script: {Walk.stp: {}, Walk.rest: {}}\n") ==
        R"(test.scenario.yaml:2:15: error: the group `Walk` has no provider or handler called `stp` [undefined_name]
    2 | script: {Walk.stp: {}, Walk.rest: {}}
      |               ^~~
  help: did you mean `stop`?
test.scenario.yaml:2:29: error: the group `Walk` has no provider or handler called `rest` [undefined_name]
    2 | script: {Walk.stp: {}, Walk.rest: {}}
      |                             ^~~~
  help: one of walking, halting, start, stop
2 errors
)");
}

TEST_CASE("a request that says more than its task is refused with what is to be written") {
  CHECK(findings("steps: [{request: Walk(3)}, {cancel: Walk.halting}, {cancel: all}]\n") ==
        R"(test.scenario.yaml:2:19: error: there is no group called `Walk(3)` [undefined_name]
    2 | steps: [{request: Walk(3)}, {cancel: Walk.halting}, {cancel: all}]
      |                   ^~~~~~~
  help: data belongs in `data`: `{Walk: {data: 3}}`
test.scenario.yaml:2:38: error: there is no group called `Walk.halting` [undefined_name]
    2 | steps: [{request: Walk(3)}, {cancel: Walk.halting}, {cancel: all}]
      |                                      ^~~~~~~~~~~~
  help: a request names the group, `Walk`: its provider is chosen by `when` and `needs`
test.scenario.yaml:2:62: error: there is no group called `all` [undefined_name]
    2 | steps: [{request: Walk(3)}, {cancel: Walk.halting}, {cancel: all}]
      |                                                              ^~~
  help: one of Walk, Kick
3 errors
)");
}

TEST_CASE("the trigger of a broken promise is fired by the engine, for those that listen to it") {
  const char* const brakes = R"(behaviour: brakes
language: 1
states: {Motion: {values: [still, rolling], initial: rolling}}
roots: [Drive]
groups:
  Drive: {providers: [{name: brake, causing: [Motion == still within 1 s]}]}
)";
  CHECK(
      load_scenario(brakes, "script: {Drive: {trigger: Drive.brake.broken}}\nsteps: [{trigger: Drive.brake.broken}]\n")
          .findings ==
      R"(test.scenario.yaml:2:27: error: no provider listens to `Drive.brake.broken` [undefined_name]
    2 | script: {Drive: {trigger: Drive.brake.broken}}
      |                           ^~~~~~~~~~~~~~~~~~
  help: list it in the `triggers` of the provider that reacts to it
test.scenario.yaml:3:19: error: a step cannot fire `Drive.brake.broken`: only the engine does [undefined_name]
    3 | steps: [{trigger: Drive.brake.broken}]
      |                   ^~~~~~~~~~~~~~~~~~
  help: let the script of `Drive.brake` not set what it promises, and `advance` beyond its `within`
2 errors
)");
}

TEST_CASE("a promise without a time has no trigger") {
  const char* const brakes = R"(behaviour: brakes
language: 1
states: {Motion: {values: [still, rolling], initial: rolling}}
roots: [Drive]
groups:
  Drive: {providers: [{name: brake, causing: [Motion == still]}]}
)";
  CHECK(load_scenario(brakes, "script: {Drive: {trigger: Drive.brake.broken}}\nsteps: []\n")
            .findings.starts_with("test.scenario.yaml:2:27: error: there is no trigger called `Drive.brake.broken` "
                                  "[undefined_name]\n"));
}

TEST_CASE("what some provider of a group can do is no finding at an entry for the group") {
  CHECK(findings("script: {Walk: {set: {Pose: standing}}}\n") == "");
}

TEST_CASE("what no provider of a group can do is one finding at an entry for the group") {
  CHECK(
      findings("script: {Walk: {set: {Charge: 3}}}\n") ==
      R"(test.scenario.yaml:2:31: error: `Walk.walking` sets `Charge` to `3`, which it does not declare [undeclared_state_write]
    2 | script: {Walk: {set: {Charge: 3}}}
      |                               ^
  help: what it declares is `Mode`
1 error
)");
}
