// SPDX-License-Identifier: MIT
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

/// What happens while the two take turns.
Lines turns(Machine& machine, int times) {
  Lines out;
  for (int i = 0; i < times; ++i) {
    machine.request("Left", i % 2 == 0 ? "high" : "low");
    append(out, machine.step());
  }
  return out;
}

TEST_CASE("what was decided before is decided again without a pass") {
  Machine machine(rivals, 64, Recalls::yes);
  machine.request("Left", "low");
  machine.request("Right");
  machine.step();
  const Lines first = turns(machine, 4);
  const std::uint64_t passes = machine.engine().passes(), recalled = machine.engine().recalled();
  CHECK(turns(machine, 4) == first);
  CHECK(machine.engine().passes() == passes);
  CHECK(machine.engine().recalled() > recalled);
}

TEST_CASE("without a memory for it nothing is recalled, and the same happens") {
  Machine with(rivals, 64, Recalls::yes), without(rivals);
  for (Machine* machine : {&with, &without}) {
    machine->request("Left", "low");
    machine->request("Right");
    machine->step();
  }
  CHECK(turns(with, 8) == turns(without, 8));
  CHECK(with.engine().recalled() > 0);
  CHECK(without.engine().recalled() == 0);
}

TEST_CASE("why a task is queued is read from the decision that was recalled, also by a copy of what stands") {
  Machine machine(rivals, 64, Recalls::yes);
  machine.request("Left", "low");
  machine.request("Right");
  machine.step();
  turns(machine, 4);
  const std::uint64_t passes = machine.engine().passes();
  turns(machine, 1);
  REQUIRE(machine.engine().passes() == passes);
  const std::vector<Queued> older(machine.tables().edges.size(), Queued{Why::deferred, 0});
  View view = machine.engine().view();
  view.left_queued = older.data();
  std::vector<std::uint64_t> room(View::bytes(Shape::of(machine.tables())) / sizeof(std::uint64_t));
  const View copy = view.copy(reinterpret_cast<std::byte*>(room.data()));
  for (const View& each : {view, copy}) {
    CHECK(each.queued(machine.edge("Left>Shared")) == Queued{});
    CHECK(each.queued(machine.edge("Right>Shared")).why == Why::blocked);
  }
  turns(machine, 2); // the other way round
  CHECK(machine.engine().queued(machine.edge("Left>Shared")).why == Why::blocked);
  CHECK(copy.queued(machine.edge("Right>Shared")).why == Why::blocked);
}

/// One input that asks for several tasks.
void ask_for_all(Machine& machine, const std::vector<std::pair<std::string, std::size_t>>& tasks) {
  std::vector<Input> input;
  for (const auto& [group, level] : tasks) {
    const Index edge = machine.edge("root>" + group);
    input.push_back({.kind = Input::Kind::request, .thing = edge, .level = machine.level(edge, level)});
    input.back().more = input.size() < tasks.size();
  }
  REQUIRE(machine.inbox().post(input));
}

TEST_CASE("who runs first is known after moves that were recalled, whoever asks") {
  const std::string robot = R"(
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
)";
  constexpr std::size_t low = 0, high = 1;
  const auto play = [&](Recalls recalls) {
    Machine machine(robot, 64, recalls);
    Lines out;
    const auto all = [&](const std::vector<std::pair<std::string, std::size_t>>& tasks) {
      ask_for_all(machine, tasks);
      append(out, machine.step());
      out.push_back("");
    };
    const auto turn = [&] {
      all({{"Left", high}});
      all({{"Left", high}, {"Right", 0}}); // nothing changes
      all({{"Left", low}});
    };
    all({{"Left", low}, {"Right", 0}, {"Lamp", 0}});
    for (int i = 0; i < 4; ++i) turn();
    for (std::size_t i = 1; i < 12; ++i) {
      turn();
      all({{"Left", low}, {"Right", 0}}); // nor here
      turn();
      all({{"Left", low}, {"Right", 0}, {"Lamp", i % 3}}); // it does elsewhere
      all({{"Left", high}, {"Right", 0}, {"Lamp", i % 3}}); // it does here
      all({{"Left", low}, {"Right", 0}, {"Lamp", i % 3}});
    }
    CHECK((machine.engine().recalled() > 40) == (recalls == Recalls::yes));
    return out;
  };
  CHECK(play(Recalls::yes) == play(Recalls::no));
}

TEST_CASE("another value, or a provider that is disabled, is another situation") {
  Machine machine(rivals, 64, Recalls::yes);
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

TEST_CASE("which of two equals was asked for first is told from the other order") {
  const std::string equals = R"(
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
)";
  Machine machine(equals, 64, Recalls::yes);
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
  CHECK(machine.engine().recalled() > 0);
}

TEST_CASE(
    "what follows from a known move follows whole: handlers, periods, and who stands as before but was asked anew") {
  const std::string robot = R"(
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
)";
  const auto play = [&](Recalls recalls) {
    Machine machine(robot, 64, recalls);
    machine.handler("Legs.start", [&](Handling& it) { it.set(machine.state("Pose"), machine.value("Pose", "down")); });
    machine.handler("Legs.stop", [&](Handling& it) { it.set(machine.state("Pose"), machine.value("Pose", "up")); });
    machine.decisions = true;
    Lines out;
    Time now = 0;
    const auto step = [&] {
      out.push_back("at " + std::to_string(now));
      append(out, machine.step(now));
      now += 7'000;
    };
    for (int i = 0; i < 12; ++i) {
      machine.request("Play");
      step();
      machine.request("Rest", "high");
      machine.request("Play");
      step();
      machine.request("Rest", "low");
      step();
      machine.cancel("Play");
      step();
      machine.cancel("Rest");
      step();
    }
    CHECK((machine.engine().recalled() > 20) == (recalls == Recalls::yes));
    return out;
  };
  CHECK(play(Recalls::yes) == play(Recalls::no));
}

TEST_CASE("a memory that is full begins anew") {
  std::string many = "{behaviour: b, language: 1, states: {N: {range: [0, 63], initial: 0, external: true}},"
                     " roots: {A: {}}, groups: {A: {providers: [";
  for (int i = 0; i < 64; ++i)
    many += "{name: p" + std::to_string(i) + ", when: [N == " + std::to_string(i) + "]}" + (i == 63 ? "" : ", ");
  Machine machine(many + "]}}}", 64, Recalls::yes);
  machine.request("A");
  machine.step();
  for (int round = 0; round < 3; ++round) {
    for (int i = 1; i <= 64; ++i) {
      machine.set("N", std::to_string(i % 64));
      CHECK(machine.step() == Lines{"run A.p" + std::to_string(i % 64) + " new_task"});
    }
  }
  // Of little use as it was, it rests, whatever comes; then it recalls again, and nothing of before.
  for (int i = 1; i <= 2 * Recall::rest; ++i) {
    machine.set("N", std::to_string(i % 3));
    CHECK(machine.step() == Lines{"run A.p" + std::to_string(i % 3) + " new_task"});
  }
  const std::uint64_t passes = machine.engine().passes();
  machine.set("N", "0");
  CHECK(machine.step() == Lines{"run A.p0 new_task"});
  CHECK(machine.engine().passes() == passes);
}

TEST_CASE("components that are large or have nothing to ask for take no memory") {
  std::string large = "{behaviour: b, language: 1, roots: {A: {}}, groups: {A: {tasks: [";
  std::string groups;
  for (int i = 0; i < 64; ++i) {
    large += "G" + std::to_string(i) + (i == 63 ? "" : ", ");
    groups += ", G" + std::to_string(i) + ": {}";
  }
  Machine machine(large + "]}" + groups + "}}", 64, Recalls::yes);
  CHECK(Recall::bytes(machine.tables()) == 0);
  machine.request("A");
  CHECK(machine.step().size() == 65);
  CHECK(machine.engine().recalled() == 0);
}

TEST_CASE("a reset forgets what was decided") {
  Machine machine(rivals, 64, Recalls::yes);
  machine.request("Right");
  machine.step();
  const Lines first = turns(machine, 4);
  turns(machine, 4);
  machine.engine().reset();
  CHECK(machine.engine().recalled() == 0);
  machine.request("Right");
  machine.step();
  CHECK(turns(machine, 4) == first);
}

} // namespace
} // namespace director::tests
