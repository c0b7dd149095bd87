// SPDX-License-Identifier: MIT
// Decisions of a pass, with the reasons that users see. Section 4 as a whole is tested by the scenarios of
// tests/conformance and by the oracle.

#include "tests/runtime/core/machine.hpp"

namespace director::tests {
namespace {

const std::string walker = R"(
behaviour: walker
language: 1
states: {Pose: {values: [moving, standing]}}
roots: {Walk: {priority: 10}, Kick: {priority: 20}}
groups:
  Walk:
    providers:
      - {name: walking, needs: [Legs], sets: [Pose == moving], tasks: [Legs]}
      - {name: halting, needs: [Legs], causing: [Pose == standing], tasks: [Legs]}
  Kick: {when: [Pose == standing], needs: [Legs], tasks: [Legs]}
  Legs: {}
)";

TEST_CASE("a stronger task that waits pushes, and takes over once its condition is true") {
  Machine machine(walker);
  machine.decisions = true;
  bool still = false;
  machine.body("Walk.halting", [&](Run& run) {
    if (still) run.set(0, 1);
    return machine.everything(run);
  });
  machine.request("Walk");
  CHECK(machine.step() == Lines{"grant root>Walk after nobody", "grant Walk>Legs after nobody",
                                "run Walk.walking new_task", "run Legs new_task"});
  machine.request("Kick");
  CHECK(machine.step() == Lines{"push Walk.halting for root>Kick", "queue root>Kick waiting", "run Walk.halting pushed",
                                "run Legs new_task"});
  still = true;
  machine.request("Walk");
  CHECK(machine.step() == Lines{"run Walk.halting new_task", "set Pose standing", "queue root>Walk blocked",
                                "lose root>Walk", "grant root>Kick after nobody", "grant Kick>Legs after Walk>Legs",
                                "run Kick new_task", "run Legs new_task"});
  machine.cancel("Kick");
  CHECK(machine.step() == Lines{"release Walk", "grant root>Walk after nobody", "lose root>Kick",
                                "grant Walk>Legs after Kick>Legs", "run Walk.walking new_task", "run Legs new_task"});
}

TEST_CASE("a push waives no conditions for groups below the pusher, nor for its needs") {
  Machine machine(R"(
behaviour: reading
language: 1
states: {Light: {values: [off, on], initial: off}}
roots: {Search: {priority: 10}, Study: {priority: 20}}
groups:
  Search: {tasks: [Lamp]}
  Study: {when: [Light == on], tasks: [Read]}
  Read: {needs: [Lamp]}
  Lamp: {when: [Light == off], causing: [Light == on]}
)");
  machine.decisions = true;
  bool pushed = false;
  machine.body("Lamp", [&](Run& run) {
    if (pushed) run.set(0, 1);
    return machine.everything(run);
  });
  machine.request("Search");
  machine.step();
  machine.request("Study");
  pushed = true;
  CHECK(machine.step() == Lines{"push Lamp for root>Study", "queue root>Study waiting", "run Lamp pushed",
                                "set Light on", "grant root>Study after nobody", "run Study new_task",
                                "queue Study>Read waiting"});
}

TEST_CASE("a stale group gets nothing new before it has run") {
  Machine machine(R"(
behaviour: orders
language: 1
states: {Hand: {values: [open, shut], initial: shut, external: true}}
roots: [Plan]
groups:
  Plan: {tasks: [Hold]}
  Hold: {when: [Hand == open]}
)");
  machine.decisions = true;
  machine.request("Plan");
  CHECK(machine.step() == Lines{"grant root>Plan after nobody", "run Plan new_task", "queue Plan>Hold waiting"});
  machine.request("Plan");
  machine.set("Hand", "open"); // both before Plan runs: it may withdraw Hold
  machine.body("Plan", [](Run& run) { return run.pack(); });
  CHECK(machine.step() == Lines{"run Plan new_task"}); // and its reason is not reported again
}

TEST_CASE("a request of a group that is stale immediately is queued as outdated") {
  Machine machine(R"(
behaviour: orders
language: 1
states: {Hand: {values: [open, shut], initial: shut}}
roots: [Plan]
groups:
  Plan:
    providers:
      - {name: first, when: [Hand == shut], tasks: [Hold], sets: [Hand == open]}
      - {name: second, tasks: [Hold]}
  Hold: {}
)");
  machine.decisions = true;
  machine.body("Plan.first", [&](Run& run) {
    run.set(machine.state("Hand"), machine.value("Hand", "open"));
    run.request(machine.edge("Plan>Hold"), machine.level(machine.edge("Plan>Hold")));
    return run.pack();
  });
  machine.body("Plan.second", [](Run& run) { return run.pack(); });
  machine.request("Plan");
  CHECK(machine.step() == Lines{"grant root>Plan after nobody", "run Plan.first new_task", "set Hand open",
                                "queue Plan>Hold outdated", "run Plan.second new_task"});
}

TEST_CASE("a weaker task waits while a stronger planner is about to decide") {
  Machine machine(R"(
behaviour: gap
language: 1
roots: {Plan: {priority: 20}, Idle: {priority: 10}}
groups:
  Plan: {tasks: [Legs]}
  Idle: {tasks: [Legs]}
  Legs: {start: true}
)");
  machine.decisions = true;
  machine.request("Idle");
  machine.step();
  machine.request("Plan");
  machine.body("Plan", [&](Run& run) { return machine.everything(run); });
  CHECK(machine.step() == Lines{"grant root>Plan after nobody", "run Plan new_task", "queue Idle>Legs blocked",
                                "grant Plan>Legs after Idle>Legs", "run Legs new_task"});
}

} // namespace
} // namespace director::tests
