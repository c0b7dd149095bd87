// SPDX-License-Identifier: MIT
#include "tests/compiler/support/played.hpp"

using director::tests::play;
using Lines = std::vector<std::string>;

namespace {

const char* const walker = R"(behaviour: walker
language: 1
states:
  Pose: {values: [moving, standing]}
  Charge: {range: [0, 9], external: true, expires: 20 ms}
triggers: [Bell]
roots:
  Walk: {priority: 10}
  Kick: {priority: {calm: 20, urgent: 30}}
groups:
  Walk:
    start: true
    stop: {sets: [Pose]}
    providers:
      - {name: walking, needs: [Legs], sets: [Pose == moving], tasks: [Legs], uses: [Legs], triggers: [Bell]}
      - {name: halting, needs: [Legs], causing: [Pose == standing], tasks: [Legs]}
  Kick:
    when: [Pose == standing]
    packs: {hard: {Legs: {priority: {slow: 1, fast: 2}}, Arms: {optional: true}}, soft: {Legs: {}}}
    needs: [Legs]
  Legs: {}
  Arms: {}
)";

} // namespace

TEST_CASE("what the script does not mention requests its first pack or all its tasks, without data") {
  CHECK(play(walker, R"(given: {Pose: standing}
script: {Legs: {data: 1, done: true}}
steps:
  - request: Kick
  - cancel: Kick
  - request: Walk
)") == Lines{"> request Kick", "run Kick new_task", "run Legs new_task", "run Arms new_task", "> cancel Kick",
             "> request Walk", "start Walk", "run Walk.walking new_task", "run Legs new_task"});
}

TEST_CASE("a body may leave out an optional entry of a pack") {
  CHECK(play(walker, R"(given: {Pose: standing}
script: {Kick: {pack: hard, with: [Legs: {level: fast}], without: [Arms]}}
steps:
  - request: Kick
)") == Lines{"> request Kick", "run Kick new_task", "run Legs new_task"});
}

TEST_CASE("the first case whose guards hold is used, and without one it continues") {
  CHECK(play(walker, R"(
script:
  Walk.walking:
    - {run: 3, done: true}
    - {trigger: Bell, tasks: []}
    - {reason: subtask_done, continue: true}
    - {run: 1, tasks: [Legs]}
  Legs: [{run: 1, continue: true}, {failed: true}]
steps:
  - request: Walk
  - trigger: Bell
  - trigger: Bell
)") == Lines{"> request Walk", "start Walk", "run Walk.walking new_task", "run Legs new_task", "> trigger Bell",
             "run Walk.walking trigger", "> trigger Bell", "run Walk.walking trigger", "done Walk", "stop Walk"});
}

TEST_CASE("cases for one call each are used in turn, and the one behind them for all other calls") {
  CHECK(play(walker, R"(
script:
  Walk.walking:
    - {run: 1, tasks: [Legs]}
    - {run: 2, tasks: []}
    - {run: 4, done: true}
    - {tasks: [Legs]}
steps:
  - request: Walk
  - trigger: Bell
  - trigger: Bell
  - trigger: Bell
)") == Lines{"> request Walk", "start Walk", "run Walk.walking new_task", "run Legs new_task", "> trigger Bell",
             "run Walk.walking trigger", "> trigger Bell", "run Walk.walking trigger", "run Legs new_task",
             "> trigger Bell", "run Walk.walking trigger", "done Walk", "stop Walk"});
}

TEST_CASE("a body sees how its tasks are doing") {
  const char* const script = R"(
script:
  Walk.walking:
    - {uses: {Legs: failed}, done: true}
    - {uses: {Legs: done}, tasks: []}
    - {uses: {Legs: running}, continue: true}
    - {uses: {Legs: none}, tasks: [Legs: {data: 7}]}
  Legs: [{data: 7, run: 1, done: true}, {data: 7, failed: true}]
steps:
  - request: Walk
  - trigger: Bell
)";
  CHECK(play(walker, script) == Lines{"> request Walk", "start Walk", "run Walk.walking new_task", "run Legs new_task",
                                      "done Legs", "run Walk.walking subtask_done", "> trigger Bell",
                                      "run Walk.walking trigger", "run Legs new_task", "failed Legs",
                                      "run Walk.walking subtask_done", "done Walk", "stop Walk"});
}

TEST_CASE("a task that has failed is not done for its requester") {
  const char* const script = R"(
script:
  Walk.walking:
    - {uses: {Legs: done}, tasks: []}
    - {uses: {Legs: failed}, done: true}
    - {tasks: [Legs]}
  Legs: {failed: true}
steps:
  - request: Walk
)";
  CHECK(play(walker, script) == Lines{"> request Walk", "start Walk", "run Walk.walking new_task", "run Legs new_task",
                                      "failed Legs", "run Walk.walking subtask_done", "done Walk", "stop Walk"});
}

TEST_CASE("tasks carry data of any kind, and a request beside a pack changes one of its tasks") {
  CHECK(play(walker, R"(given: {Pose: standing}
script:
  Kick:
    - {reason: subtask_done, continue: true}
    - {data: [1, {a: x}], pack: hard, with: [Legs: {level: fast, data: {b: 2.5, c: true}}]}
    - {data: urgent, pack: soft}
  Legs: [{data: {c: true, b: 2.5}, done: true}, {continue: true}]
steps:
  - request: {Kick: {data: [1, {a: x}]}}
  - request: {Kick: {level: urgent, data: urgent}}
)") == Lines{"> request {Kick: {data: [1, {a: x}]}}", "run Kick new_task", "run Legs new_task", "done Legs",
             "run Arms new_task", "run Kick subtask_done", "> request {Kick: {level: urgent, data: urgent}}",
             "run Kick new_task", "run Legs new_task"});
}

TEST_CASE("a request that is kept is no new task") {
  CHECK(play(walker, R"(
script:
  Walk.walking: [{trigger: Bell, tasks: [Legs: {keep: true}]}, {tasks: [Legs]}]
steps:
  - request: Walk
  - trigger: Bell
)") == Lines{"> request Walk", "start Walk", "run Walk.walking new_task", "run Legs new_task", "> trigger Bell",
             "run Walk.walking trigger"});
}

TEST_CASE("several inputs are queued before the engine runs, and one input may request several roots") {
  CHECK(play(walker, R"(
steps:
  - inputs: [{set: {Charge: 3}}, {request: [Walk, Kick]}, {disable: Walk.walking}, {enable: Walk.walking}]
)") == Lines{"> set {Charge: 3}", "> request [Walk, Kick]", "> disable Walk.walking", "> enable Walk.walking",
             "start Walk", "run Walk.halting new_task+pushed", "run Legs new_task"});
}

TEST_CASE("time stops at each due time, and goes on where the scenario left it") {
  CHECK(play(walker, R"(
script:
  Walk.walking: [{reason: wait, tasks: [], wait: 10 ms}, {tasks: [], wait: 15 ms}]
steps:
  - inputs: [{request: Walk}, {set: {Charge: 5}}]
  - advance: 14 ms
  - advance: 1 ms
  - advance: 20 ms
)",
             true) == Lines{"> request Walk", "> set {Charge: 5}", "start Walk", "run Walk.walking new_task",
                            "> advance 14 ms", "> advance 1 ms", "run Walk.walking wait", "> advance 20 ms",
                            "unset Charge", "run Walk.walking wait", "run Walk.walking wait"});
}

TEST_CASE("decisions are printed on request") {
  const char* const script = R"(
script:
  Walk.walking: {set: {Pose: moving}, tasks: [Legs]}
  Walk.halting: {set: {Pose: standing}, tasks: [Legs]}
steps:
  - request: Walk
  - request: Kick
  - cancel: Kick
)";
  CHECK(play(walker, script, true) == Lines{"> request Walk",
                                            "start Walk",
                                            "run Walk.walking new_task",
                                            "set Pose moving",
                                            "run Legs new_task",
                                            "> request Kick",
                                            "push Walk.halting for root>Kick",
                                            "queue root>Kick: waiting for Pose == standing",
                                            "run Walk.halting pushed",
                                            "set Pose standing",
                                            "queue root>Walk: blocked",
                                            "stop Walk",
                                            "run Kick new_task",
                                            "run Legs new_task",
                                            "run Arms new_task",
                                            "> cancel Kick",
                                            "release Walk",
                                            "start Walk",
                                            "run Walk.walking new_task",
                                            "set Pose moving",
                                            "run Legs new_task"});
  CHECK(play(walker, script) == Lines{"> request Walk", "start Walk", "run Walk.walking new_task", "run Legs new_task",
                                      "> request Kick", "run Walk.halting pushed", "stop Walk", "run Kick new_task",
                                      "run Legs new_task", "run Arms new_task", "> cancel Kick", "start Walk",
                                      "run Walk.walking new_task", "run Legs new_task"});
}

TEST_CASE("a scenario that never rests ends with its budget") {
  const Lines lines = play(R"(behaviour: restless
language: 1
roots: [A]
groups: {A: {tasks: [B]}, B: {}}
)",
                           R"(
script: {B: {done: true}}
steps:
  - request: A
  - cancel: A
)");
  CHECK(lines.size() == 15'000);
  CHECK(lines.front() == "> request A");
  CHECK(lines.back() == "budget_exhausted");
}

TEST_CASE("what this provider of a group may not do ends the scenario where it comes to it") {
  CHECK(
      play(walker, R"(
script: {Walk: {set: {Pose: standing}, tasks: []}}
steps:
  - request: Walk
  - request: Kick
  - cancel: Walk
)") ==
      Lines{
          "> request Walk", "start Walk", "run Walk.walking new_task",
          R"(test.scenario.yaml:3:29: error: `Walk.walking` sets `Pose` to `standing`, which it does not declare [undeclared_state_write]
    3 | script: {Walk: {set: {Pose: standing}, tasks: []}}
      |                             ^~~~~~~~
  help: what it declares is `Pose == moving`
)"});
}

TEST_CASE("a state that is set to the value it has is set anew only for its expiry") {
  CHECK(play(walker, R"(
steps:
  - set: {Charge: 1}
  - advance: 15 ms
  - set: {Charge: 1}
  - advance: 15 ms
  - advance: 5 ms
)",
             true) == Lines{"> set {Charge: 1}", "> advance 15 ms", "> set {Charge: 1}", "> advance 15 ms",
                            "> advance 5 ms", "unset Charge"});
}

TEST_CASE("time has an end, and what is due near it is due all the same") {
  const std::string age = "  - advance: 999999999999 s\n";
  std::string steps = "steps:\n  - request: Walk\n";
  Lines expected{"> request Walk", "start Walk", "run Walk.walking new_task", "run Legs new_task"};
  for (int i = 0; i < 10; ++i) {
    steps += age;
    expected.push_back("> advance 999999999999 s");
  }
  steps += "  - trigger: Bell\n" + age;
  expected.insert(expected.end(), {"> trigger Bell", "run Walk.walking trigger", "> advance 999999999999 s"});
  CHECK(play(walker, "script: {Walk.walking: [{reason: trigger, wait: 999999999999 s}, {tasks: [Legs]}]}\n" + steps) ==
        expected);
}
