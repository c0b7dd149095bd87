// SPDX-License-Identifier: MIT
// Repeated situations: the same inputs lead to the same decisions again, and differences to others.
#include "runtime/core/inspect/view.hpp"
#include "tests/runtime/core/machine.hpp"

#include <catch2/catch.hpp>

namespace director::tests {
namespace {

const std::string rivals = R"(
behaviour: rivals
language: 1
states:
  Light: {values: [red, green], initial: red, external: true}
roots:
  Left: {priority: {low: 1, high: 3}}
  Right: {priority: 2}
groups:
  Left: {tasks: [Shared]}
  Right: {tasks: [Shared]}
  Shared:
    providers:
      - {name: go, when: [Light == green]}
      - {name: stand}
)";

void append(Lines& to, Lines lines) {
  for (std::string& line : lines) to.push_back(std::move(line));
}

/// The runs while the two tasks alternate.
Lines turns(Machine& machine, int times) {
  Lines out;
  for (int i = 0; i < times; ++i) {
    machine.request("Left", i % 2 == 0 ? "high" : "low");
    append(out, machine.step());
  }
  return out;
}

/// Right holds the group that both need.
void begin(Machine& machine) {
  machine.request("Left", "low");
  machine.request("Right");
  CHECK(machine.step() == Lines{"run Left new_task", "run Right new_task", "run Shared.stand new_task"});
}

const Lines two_turns{"run Left new_task", "run Shared.stand new_task", "run Shared.stand new_task",
                      "run Left new_task"};

TEST_CASE("the run of a group that repeats its requests takes no pass, unless a decision waits for it") {
  Machine machine(rivals);
  begin(machine);
  const auto passes = [&machine](const std::string& level, const Lines& expected) {
    const std::uint64_t before = machine.engine().passes();
    machine.request("Left", level);
    CHECK(machine.step() == expected);
    return machine.engine().passes() - before;
  };
  const Lines first_left{"run Left new_task", "run Shared.stand new_task"};
  const Lines first_shared{"run Shared.stand new_task", "run Left new_task"};
  CHECK(passes("high", first_left) == 2);  // Left gets it after its run
  CHECK(passes("low", first_shared) == 1); // Right gets it at once
  CHECK(passes("high", first_left) == 2);
  machine.cancel("Right");
  CHECK(machine.step().empty());
  CHECK(passes("low", first_left) == 1); // it keeps the group
}

TEST_CASE("two tasks that alternate get the same each time, also after a reset") {
  Machine machine(rivals);
  begin(machine);
  for (int i = 0; i < 4; ++i) CHECK(turns(machine, 2) == two_turns);
  machine.engine().reset();
  begin(machine);
  CHECK(turns(machine, 2) == two_turns);
}

TEST_CASE("the reason why a task is queued follows the task that holds the group; a copy of the view does not change") {
  Machine machine(rivals);
  begin(machine);
  turns(machine, 1);
  const View view = view_of(machine.engine());
  std::vector<std::uint64_t> buffer(View::bytes(Shape::of(machine.tables())) / sizeof(std::uint64_t));
  const View copy = view.copy(reinterpret_cast<std::byte*>(buffer.data()));
  const auto left_runs = [&](const View& each) {
    CHECK(each.queued(machine.edge("Left>Shared")) == Queued{});
    CHECK(each.queued(machine.edge("Right>Shared")).why == Why::blocked);
  };
  left_runs(view);
  left_runs(copy);
  turns(machine, 2);
  CHECK(view.queued(machine.edge("Left>Shared")).why == Why::blocked);
  CHECK(view.queued(machine.edge("Right>Shared")) == Queued{});
  left_runs(copy);
}

/// Posts one input that requests several tasks.
void request_all(Machine& machine, const std::vector<std::pair<std::string, std::size_t>>& tasks) {
  std::vector<Input> input;
  for (const auto& [group, level] : tasks) {
    const Index edge = machine.edge("root>" + group);
    input.push_back(
        {.kind = Input::Kind::request, .thing = edge, .value = static_cast<std::int32_t>(machine.level(edge, level))});
    input.back().more = input.size() < tasks.size();
  }
  REQUIRE(machine.inbox().post(input));
}

TEST_CASE("runs follow the current order, whichever tasks are requested, and also if other decisions are made") {
  Machine machine(R"(
behaviour: robot
language: 1
states:
  Light: {values: [red, green], initial: red}
roots:
  Left: {priority: {low: 1, high: 3}}
  Right: {priority: 2}
  Lamp: {priority: {dim: 1, bright: 2, dark: 3}}
groups:
  Left: {causing: [Light == green]}
  Right: {providers: [{name: go, when: [Light == green]}, {name: stand}]}
  Lamp: {}
)");
  constexpr std::size_t low = 0, high = 1, dim = 0, bright = 1, dark = 2;
  const auto all = [&](const std::vector<std::pair<std::string, std::size_t>>& tasks) {
    request_all(machine, tasks);
    return machine.step();
  };
  const std::string left = "run Left new_task", right = "run Right.stand new_task", lamp = "run Lamp new_task";
  CHECK(all({{"Left", low}, {"Right", 0}, {"Lamp", dim}}) == Lines{right, left, lamp});
  for (int i = 0; i < 4; ++i) {
    CHECK(all({{"Left", high}}) == Lines{left});
    CHECK(all({{"Left", high}, {"Right", 0}}) == Lines{left, right});
    CHECK(all({{"Left", low}}) == Lines{left});
    CHECK(all({{"Left", low}, {"Right", 0}}) == Lines{right, left});
    CHECK(all({{"Left", low}, {"Right", 0}, {"Lamp", bright}}) == Lines{right, lamp, left});
    CHECK(all({{"Left", high}, {"Right", 0}, {"Lamp", bright}}) == Lines{left, right, lamp});
    CHECK(all({{"Left", low}, {"Right", 0}, {"Lamp", dark}}) == Lines{lamp, right, left});
  }
}

TEST_CASE("another value, or a disabled provider, leads to another decision") {
  Machine machine(rivals);
  machine.request("Right");
  machine.step();
  turns(machine, 8);
  machine.set("Light", "green");
  CHECK(machine.step() == Lines{"run Shared.go new_task"});
  machine.enable("Shared.go", false);
  CHECK(machine.step() == Lines{"run Shared.stand new_task"});
  machine.enable("Shared.go", true);
  CHECK(machine.step() == Lines{"run Shared.go new_task"});
  machine.set("Light", "red");
  CHECK(machine.step() == Lines{"run Shared.stand new_task"});
}

TEST_CASE("of two equals the one that was requested first goes first, in either order") {
  Machine machine(R"(
behaviour: equals
language: 1
states:
  Light: {values: [red, green], initial: red, external: true}
roots:
  Left: {priority: 1}
  Right: {priority: 1}
groups:
  Left: {needs: [Shared]}
  Right: {needs: [Shared]}
  Shared: {when: [Light == green]}
)");
  for (int i = 0; i < 3; ++i) {
    for (const char* first : {"Left", "Right"}) {
      const std::string second = first == std::string("Left") ? "Right" : "Left";
      machine.request(first);
      machine.request(second);
      CHECK(machine.step().empty());
      machine.set("Light", "green");
      CHECK(machine.step() == Lines{std::string("run ") + first + " new_task"});
      machine.cancel(first);
      machine.cancel(second);
      machine.set("Light", "red");
      machine.step();
    }
  }
}

TEST_CASE("handlers, periods and new requests for unchanged groups work the same in each repetition") {
  Machine machine(R"(
behaviour: robot
language: 1
states:
  Pose: {values: [up, down], initial: up}
roots:
  Play: {priority: 1}
  Rest: {priority: {low: 0, high: 2}}
groups:
  Play: {tasks: [Arm, Legs]}
  Rest: {tasks: [Legs]}
  Arm: {}
  Legs:
    start: {sets: [Pose == down]}
    stop: {sets: [Pose == up]}
    every: 10 ms
)");
  machine.handler("Legs.start", [&](Handling& it) { it.set(machine.state("Pose"), machine.value("Pose", "down")); });
  machine.handler("Legs.stop", [&](Handling& it) { it.set(machine.state("Pose"), machine.value("Pose", "up")); });
  machine.decisions = true;
  Time now = 0;
  const auto step = [&] { return machine.step(now += 7'000); };
  for (int i = 0; i < 12; ++i) {
    INFO(i);
    machine.request("Play");
    CHECK(step() == Lines{"grant root>Play after nobody", "run Play new_task", "grant Play>Arm after nobody",
                          "grant Play>Legs after nobody", "start Legs", "set Pose down", "run Arm new_task",
                          "run Legs new_task"});
    machine.request("Rest", "high");
    machine.request("Play");
    CHECK(step() == Lines{"grant root>Rest after nobody", "run Rest new_task", "queue Play>Legs blocked",
                          "grant Rest>Legs after Play>Legs", "run Play new_task", "queue Play>Arm blocked",
                          "lose Play>Arm", "run Legs new_task"});
    machine.request("Rest", "low");
    CHECK(step() == Lines{"queue Rest>Legs blocked", "grant Play>Arm after nobody", "grant Play>Legs after Rest>Legs",
                          "run Arm new_task", "run Legs new_task", "run Rest new_task", "run Legs trigger"});
    machine.cancel("Play");
    CHECK(step() == Lines{"lose root>Play", "lose Play>Arm", "grant Rest>Legs after Play>Legs", "run Legs new_task",
                          "run Legs trigger"});
    machine.cancel("Rest");
    CHECK(step() == Lines{"lose root>Rest", "lose Rest>Legs", "stop Legs", "set Pose up"});
  }
}

} // namespace
} // namespace director::tests
