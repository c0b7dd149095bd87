// SPDX-License-Identifier: MIT
// The guarantees of `step`: time, inputs, budget, faults, several engines, task data.

#include "tests/runtime/core/machine.hpp"

#include <cstring>

namespace director::tests {
namespace {

constexpr auto ms = [](Time count) { return count * 1000; };

const std::string timed = R"(
behaviour: timed
language: 1
states:
  Ball: {values: [far, near], external: true, initial: near, expires: 100 ms}
triggers: [Picture]
roots: [Clock, Look]
groups:
  Clock: {every: 10 ms}
  Look: {when: [Ball == near], triggers: [Picture]}
)";

TEST_CASE("an initial value expires, counted from the first step") {
  Machine machine(timed);
  machine.request("Look");
  CHECK(machine.step(ms(1000)) == Lines{"run Look new_task"});
  CHECK(machine.engine().next_due() == ms(1100));
  CHECK(machine.step(ms(1099)).empty());
  CHECK(machine.step(ms(1100)) == Lines{"set Ball -"});
}

TEST_CASE("an input that was posted before the step is taken before the timers that are due in it") {
  Machine machine(timed);
  machine.request("Look");
  machine.step(0);
  machine.set("Ball", "near"); // the same value: it expires later
  CHECK(machine.step(ms(100)).empty());
  CHECK(machine.engine().next_due() == ms(200));
}

TEST_CASE("an input that bypasses the inbox is taken before later ones, and after those that wait") {
  const std::string light = R"(
behaviour: light
language: 1
states:
  Light: {values: [red, green, yellow], initial: red, external: true}
roots: [Watch]
groups:
  Watch:
    providers:
      - {name: go, when: [Light == green]}
      - {name: slow, when: [Light == yellow]}
      - {name: stand}
)";
  Machine machine(light);
  machine.request("Watch");
  machine.step();
  Input green{.kind = Input::Kind::set, .thing = machine.state("Light")};
  green.value = machine.value("Light", "green");
  CHECK(machine.engine().take_first(green));
  CHECK_FALSE(machine.engine().take_first(green)); // another input waits already
  machine.set("Light", "yellow");
  CHECK(machine.step() == Lines{"run Watch.slow new_task"}); // all inputs come before a run

  machine.set("Light", "red");
  CHECK_FALSE(machine.engine().take_first(green)); // it would overtake another input
  CHECK(machine.engine().post({&green, 1}));
  CHECK(machine.step() == Lines{"run Watch.go new_task"});
}

TEST_CASE("an input that bypasses the inbox counts among the micro-steps of its step") {
  Machine machine("{behaviour: b, language: 1, roots: [Watch], groups: {Watch: {}}}");
  machine.request("Watch");
  machine.engine().set_budget(1);
  CHECK(machine.step() == Lines{"exhausted"});
  Input again{.kind = Input::Kind::request, .thing = machine.edge("root>Watch")};
  again.set_level(machine.level(again.thing));
  CHECK(machine.engine().take_first(again)); // taken before the remaining run
  CHECK(machine.step() == Lines{"exhausted"});
  CHECK(machine.step() == Lines{"run Watch new_task"});
}

TEST_CASE("an earlier time counts as the last one") {
  Machine machine(timed);
  machine.request("Clock");
  machine.step(ms(50));
  CHECK(machine.step(ms(10)).empty());
  CHECK(machine.engine().now() == ms(50));
  CHECK(machine.engine().next_due() == ms(60));
}

TEST_CASE("a period that is late runs once and is next due at the first multiple after now") {
  Machine machine(timed);
  machine.request("Clock");
  machine.step(0);
  CHECK(machine.step(ms(35)) == Lines{"run Clock trigger"});
  CHECK(machine.engine().next_due() == ms(40));
}

TEST_CASE("an input that can change no decision takes a run and no pass") {
  Machine machine(timed);
  machine.request("Look");
  machine.step(0);
  const std::uint64_t before = machine.engine().passes();
  CHECK(before > 0);
  machine.request("Look");
  CHECK(machine.step(ms(1)) == Lines{"run Look new_task"});
  machine.set("Ball", "near");
  machine.step(ms(2));
  CHECK(machine.engine().passes() == before);
  machine.set("Ball", "far");
  machine.step(ms(3));
  CHECK(machine.engine().passes() > before);
  CHECK(machine.engine().micro_steps() > machine.engine().passes());
}

TEST_CASE("a request that is repeated alone is decided again if a decision depends on a stale group") {
  Machine machine(R"(
behaviour: watch
language: 1
states:
  Pose: {values: [moving, standing], initial: moving}
  Light: {values: [day, night], initial: day, external: true}
roots: {Watch: {priority: 20}, Walk: {priority: 10}}
groups:
  Watch: {tasks: {Look: {priority: 2}, Listen: {priority: 1}}}
  Look:
    providers:
      - {name: afar, when: [Light == day, Pose == standing]}
      - {name: by_lamp, when: [Light == night]}
  Listen: {when: [Pose == standing]}
  Walk:
    providers:
      - {name: walking}
      - {name: halting, causing: [Pose == standing]}
)");
  machine.decisions = true;
  machine.body("Walk.halting", [&](Run& run) {
    run.set(machine.state("Pose"), machine.value("Pose", "standing"));
    return run.pack();
  });
  machine.request("Walk");
  machine.request("Watch");
  machine.step();
  machine.set("Light", "night");
  CHECK(machine.step() == Lines{"run Look.by_lamp new_task"});
  // The push of Look serves Listen only, so it ends while each of them is a unit by itself.
  machine.request("Watch");
  CHECK(machine.step() == Lines{"release Walk", "run Watch new_task", "run Walk.walking new_task",
                                "run Look.by_lamp new_task", "run Listen new_task"});
}

TEST_CASE("a timer that is due runs at its own time") {
  Machine machine(R"(
behaviour: waits
language: 1
roots: [A, B]
groups:
  A: {}
  B: {}
)");
  std::vector<Time> times;
  const auto waits = [&](Time first) {
    return [&times, first](Run& run) {
      times.push_back(run.now());
      if (run.reasons().has(Reason::new_task)) run.wait(first);
      return run.pack();
    };
  };
  machine.body("A", waits(ms(30))).body("B", waits(ms(20)));
  machine.request("A");
  machine.request("B");
  machine.step(0);
  SECTION("in one step") { CHECK(machine.step(ms(100)) == Lines{"run B wait", "run A wait"}); }
  SECTION("though the budget ends before it, or together with it") {
    machine.engine().set_budget(1);
    for (int step = 0; step < 10; ++step) machine.step(ms(100));
    CHECK(machine.result() == StepResult::quiescent);
  }
  CHECK(times == std::vector<Time>{0, 0, ms(20), ms(30)});
  CHECK(machine.engine().now() == ms(100));
}

TEST_CASE("an input comes at the time of its step, though the budget of the step before ended at an earlier timer") {
  Machine machine(timed);
  machine.body("Clock", [](Run& run) { return run.keep(); });
  machine.request("Clock");
  machine.request("Look");
  machine.step(0);
  machine.set("Ball", "near");
  machine.step(ms(5));
  machine.engine().set_budget(1);
  CHECK(machine.step(ms(100)) == Lines{"exhausted"}); // at the timer of 10 ms
  machine.engine().set_budget(Engine::default_budget);
  machine.set("Ball", "near");
  CHECK(machine.step(ms(150)) == Lines{"run Clock trigger", "run Clock trigger"});
  CHECK(machine.engine().next_due() == ms(160));
  CHECK(machine.step(ms(245)) == Lines{"run Clock trigger"});
  CHECK(machine.step(ms(250)) == Lines{"set Ball -", "run Clock trigger"});
}

TEST_CASE("a step that ended early goes on where it stopped, however late the next call is") {
  const auto play = [](std::uint32_t budget, Time later) {
    Machine machine("behaviour: patrol\nlanguage: 1\nroots: [Look]\ngroups:\n  Look: {tasks: [Turn]}\n  Turn: {}\n");
    std::string runs;
    machine.body("Look", [&](Run& run) {
      runs += " Look " + std::to_string(machine.engine().now() / ms(1));
      run.wait(ms(10));
      return machine.everything(run);
    });
    machine.body("Turn", [&](Run& run) {
      runs += " Turn " + std::to_string(machine.engine().now() / ms(1));
      run.wait(ms(4));
      return run.keep();
    });
    machine.request("Look");
    machine.step(0);
    machine.engine().set_budget(budget);
    Time now = ms(20);
    while (machine.step(now), machine.result() == StepResult::budget_exhausted) now += later;
    return runs;
  };
  const std::string whole = play(Engine::default_budget, 0);
  CHECK(whole == " Look 0 Turn 0 Turn 4 Turn 8 Look 10 Turn 10 Turn 14 Turn 18 Look 20 Turn 20");
  for (const std::uint32_t budget : {1U, 2U, 3U, 5U}) {
    CAPTURE(budget);
    CHECK(play(budget, 0) == whole);
    CHECK(play(budget, ms(1)).starts_with(whole));
  }
}

TEST_CASE("a wait of the longest duration never ends, also if the time is negative when it begins") {
  Machine machine(timed);
  machine.body("Look", [](Run& run) {
    run.wait(never);
    return run.keep();
  });
  machine.request("Look");
  machine.step(-ms(1000));
  CHECK(machine.step(last_time) == Lines{"set Ball -"});
}

TEST_CASE("an input that a body posts is taken by the next step") {
  Machine machine(timed);
  machine.body("Look", [&](Run& run) {
    machine.request("Clock");
    return run.pack();
  });
  machine.request("Look");
  CHECK(machine.step(0) == Lines{"run Look new_task"});
  CHECK(machine.step(0) == Lines{"run Clock new_task"});
}

TEST_CASE("a trigger runs the providers that listen to it, which can read which one fired") {
  Machine machine(timed);
  bool seen = false;
  machine.body("Look", [&](Run& run) {
    seen = run.triggered(0);
    return run.keep();
  });
  machine.request("Look");
  machine.request("Clock");
  machine.step(0);
  CHECK_FALSE(seen);
  machine.fire("Picture");
  CHECK(machine.step(0) == Lines{"run Look trigger"});
  CHECK(seen);
}

TEST_CASE("two groups that run each other endlessly exhaust the budget, and continue with the next call") {
  Machine machine(R"(
behaviour: chatter
language: 1
roots: [Talk]
groups:
  Talk: {tasks: [Echo]}
  Echo: {}
)");
  machine.body("Echo", [](Run& run) { return run.done(); });
  machine.engine().set_budget(5);
  machine.request("Talk");
  CHECK(machine.step() == Lines{"run Talk new_task", "run Echo new_task", "done Echo", "run Talk subtask_done",
                                "run Echo new_task", "done Echo", "exhausted"});
  CHECK(machine.result() == StepResult::budget_exhausted);
  CHECK(machine.step().size() == 8);
  CHECK(machine.result() == StepResult::budget_exhausted);
  machine.cancel("Talk");
  machine.step();
  CHECK(machine.result() == StepResult::quiescent);
}

TEST_CASE(
    "a step ends when its work budget is used up, and the next one continues; together they do what one step does") {
  const std::string text = R"(
behaviour: talk
language: 1
roots: [Talk]
groups:
  Talk: {tasks: [Left, Right]}
  Left: {}
  Right: {}
)";
  Machine whole(text);
  whole.request("Talk");
  const Lines all = whole.step();
  CHECK(whole.result() == StepResult::quiescent);
  const std::uint64_t work = whole.engine().work();
  CHECK(work > 0);

  Machine parts(text);
  parts.engine().set_work_budget(1);
  parts.request("Talk");
  Lines together;
  int steps = 0;
  for (; steps == 0 || parts.result() == StepResult::budget_exhausted; ++steps) {
    REQUIRE(steps < 100);
    for (const std::string& line : parts.step()) {
      if (line != "exhausted") together.push_back(line);
    }
  }
  CHECK(together == all);
  CHECK(steps > 2);
  CHECK(parts.engine().work() == work);

  SECTION("a budget for all of it is never exhausted") {
    Machine enough(text);
    enough.engine().set_work_budget(work + 1);
    enough.request("Talk");
    CHECK(enough.step() == all);
    CHECK(enough.result() == StepResult::quiescent);
  }
}

const std::string pair = R"(
behaviour: pair
language: 1
states: {Pose: {values: [low, high], initial: low}}
roots: [Lead]
groups:
  Lead: {sets: [Pose], tasks: [Follow]}
  Follow: {start: true, stop: {sets: [Pose == low]}, data: int}
)";

TEST_CASE("a body that faults keeps its requests, sets nothing, and the step can continue") {
  Machine machine(pair);
  bool faulty = false;
  machine.body("Lead", [&](Run& run) {
    if (faulty) {
      run.set(0, 1);
      return run.fault();
    }
    run.request(machine.edge("Lead>Follow"), machine.level(machine.edge("Lead>Follow")));
    return run.pack();
  });
  machine.request("Lead");
  CHECK(machine.step() == Lines{"run Lead new_task", "start Follow", "run Follow new_task"});
  faulty = true;
  machine.request("Lead");
  CHECK(machine.step() == Lines{"run Lead new_task", "fault Lead"});
  CHECK(machine.result() == StepResult::fault);
  CHECK(machine.engine().value(0) == 0);
  CHECK(machine.engine().state(machine.edge("Lead>Follow")) == RunState::running);
  CHECK(machine.step().empty());
  CHECK(machine.result() == StepResult::quiescent);
}

TEST_CASE("a handler that faults prevents no other action of the same act") {
  Machine machine(pair);
  machine.handler("Follow.start", [](Handling& handling) { handling.fault(); });
  machine.request("Lead");
  CHECK(machine.step() == Lines{"run Lead new_task", "start Follow", "fault Follow"});
  CHECK(machine.result() == StepResult::fault);
  CHECK(machine.step() == Lines{"run Follow new_task"});
}

TEST_CASE("a body cannot step the engine") {
  Machine machine(pair);
  StepResult inner = StepResult::quiescent;
  machine.body("Follow", [&](Run& run) {
    inner = machine.engine().step(0);
    return run.pack();
  });
  machine.request("Lead");
  machine.step();
  CHECK(inner == StepResult::refused);
}

TEST_CASE("the values that a stop handler sets are an input of their own, before every other") {
  Machine machine(pair);
  machine.handler("Follow.stop", [&](Handling& handling) { handling.set(0, 0); });
  machine.body("Lead", [&](Run& run) {
    run.set(0, 1);
    run.request(machine.edge("Lead>Follow"), machine.level(machine.edge("Lead>Follow")));
    return run.pack();
  });
  machine.request("Lead");
  machine.step();
  machine.cancel("Lead");
  CHECK(machine.step() == Lines{"stop Follow", "set Pose low"});
}

TEST_CASE("data wait in the staging slot until the act is over, and stay with a group that uses them") {
  Machine machine(pair);
  std::vector<DataPlace::Slot> slots;
  machine.handler("Follow.start", [&](Handling& handling) { slots.push_back(handling.data().slot); });
  machine.body("Follow", [&](Run& run) {
    slots.push_back(run.data().slot);
    return run.pack();
  });
  machine.request("Lead");
  machine.step();
  CHECK(slots == std::vector{DataPlace::Slot::staging, DataPlace::Slot::edge});
  CHECK(machine.data_moves == Lines{"accept root>Lead", "settle root>Lead", "settle Lead>Follow"});
}

TEST_CASE("two engines on one set of tables are independent") {
  Machine machine(pair);
  EngineMemory memory(machine.tables());
  std::vector<Inbox::Cell> cells(4);
  Inbox inbox(cells);
  Bodies bodies;
  bodies.run = [](void*, Run& context) { return context.pack(); };
  bodies.start = bodies.stop = [](void*, Handling&) {};
  Engine other(machine.tables(), memory.state().data(), bodies, inbox);
  machine.request("Lead");
  machine.step();
  CHECK(other.step(0) == StepResult::quiescent);
  CHECK(other.state(machine.edge("root>Lead")) == RunState::none);
  CHECK(machine.engine().state(machine.edge("root>Lead")) == RunState::running);
}

TEST_CASE("engines with equal decision bytes continue alike") {
  Machine first(pair), second(pair);
  first.request("Lead");
  first.step();
  const std::size_t bytes = State::decision_bytes(Shape::of(first.tables()));
  std::memcpy(second.memory().data(), first.memory().data(), bytes);
  for (Machine* machine : {&first, &second}) machine->cancel("Lead");
  CHECK(first.step() == second.step());
  CHECK(std::memcmp(first.memory().data(), second.memory().data(), bytes) == 0);
}

TEST_CASE("after a reset the engine is as at the start") {
  Machine machine(pair);
  machine.request("Lead");
  const Lines first = machine.step();
  machine.engine().reset();
  CHECK(machine.engine().state(machine.edge("root>Lead")) == RunState::none);
  machine.request("Lead");
  CHECK(machine.step() == first);
}

TEST_CASE("an observer gets what a run requests, keeps and withdraws, and when it is to run again") {
  Machine machine("{behaviour: b, language: 1, roots: {A: {}},"
                  " groups: {A: {tasks: {B: {}, C: {}}}, B: {}, C: {}}}");
  machine.requests = true;
  int runs = 0;
  machine.body("A", [&](Run& run) {
    if (runs++ == 1) run.wait(5);
    run.request(machine.edge("A>B"), machine.level(machine.edge("A>B")), true);
    if (runs == 1) run.request(machine.edge("A>C"), machine.level(machine.edge("A>C")));
    return run.pack();
  });
  machine.body("B", [](Run& run) { return run.keep(); });
  machine.body("C", [](Run& run) { return run.keep(); });
  machine.request("A");
  CHECK(machine.step(10) == Lines{"run A new_task", "ask A>B", "ask A>C", "run B new_task", "run C new_task"});
  machine.request("A");
  CHECK(machine.step(20) == Lines{"run A new_task", "keep A>B", "withdraw A>C", "wait A 25"});
}

} // namespace
} // namespace director::tests
