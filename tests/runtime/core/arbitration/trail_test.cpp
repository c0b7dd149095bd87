// SPDX-License-Identifier: MIT
// Incremental passes: only units that a change reaches are decided again, in a component that is not small.

#include "tests/runtime/core/machine.hpp"

#include <algorithm>

namespace director::tests {
namespace {

/// A player, and a crowd of skills in the same component, all of which run and none of which the player uses.
std::string player_in_a_crowd(int others) {
  std::string all;
  std::string groups;
  for (int i = 0; i < others; ++i) {
    const std::string number = std::to_string(i);
    all += ", Other" + number + ": {apart: true}";
    groups +=
        "  Other" + number + ": {when: [Phase == on], needs: [Part" + number + "], tasks: [Part" + number + "]}\n";
    groups += "  Part" + number + ": {}\n";
  }
  return R"(
behaviour: crowd
language: 1
states:
  Pose: {values: [moving, standing]}
  Ball: {values: [far, near], initial: far, external: true}
  Phase: {values: [off, on], initial: on, external: true}
roots: {Play: {priority: 10}, Walk: {priority: 5}, Crowd: {priority: 1}}
groups:
  Play: {when: [Ball == near], packs: {go: {Kick: {}, Look: {apart: true}}}}
  Kick: {when: [Pose == standing], needs: [Legs], tasks: [Legs]}
  Look: {}
  Walk:
    providers:
      - {name: walking, needs: [Legs], sets: [Pose == moving], tasks: [Legs]}
      - {name: halting, needs: [Legs], causing: [Pose == standing], tasks: [Legs]}
  Legs: {}
  Crowd: {packs: {all: {Look: {apart: true})" +
         all + "}}}\n" + groups;
}

/// The work that the engine does for each input of a player.
std::vector<std::uint64_t> work_of(int others) {
  Machine machine(player_in_a_crowd(others));
  machine.body("Walk.halting", [&](Run& run) {
    run.set(0, 1);
    return machine.everything(run);
  });
  machine.request("Crowd");
  machine.step();
  std::vector<std::uint64_t> out;
  const auto count = [&](bool taken) {
    REQUIRE(taken);
    const std::uint64_t before = machine.engine().work();
    machine.step();
    out.push_back(machine.engine().work() - before);
  };
  count(machine.request("Walk"));
  count(machine.request("Play"));
  count(machine.set("Ball", "near"));
  count(machine.request("Play"));
  count(machine.enable("Walk.halting", false));
  count(machine.set("Ball", "far"));
  count(machine.cancel("Walk"));
  count(machine.cancel("Play"));
  return out;
}

TEST_CASE("units that no change reaches are not decided again, whatever their number") {
  std::vector<std::uint64_t> few = work_of(12), many = work_of(212);
  // Which groups may be pushed is not noted: when a provider is disabled, all of its component is decided again.
  constexpr std::size_t disabled = 4;
  CHECK(few[disabled] < many[disabled]);
  few[disabled] = many[disabled] = 0;
  CHECK(few == many);
}

/// The decisions when two tasks wait for one condition, and the push of the first one serves both until it is dropped.
Lines served_by_another(Index most_decided_whole) {
  Machine machine(R"(
behaviour: pushes
language: 1
states: {Pose: {range: [0, 2], external: true, expires: 50 ms}}
roots: {Kick: {}, Play: {}}
groups:
  Kick: {when: [Pose < 1]}
  Play: {tasks: {Plan: {}, Look: {}}}
  Plan: {packs: {whole: {Step: {}}}}
  Step: {tasks: {Walk: {optional: true}}}
  Look: {providers: [{name: down, when: [Pose == 0]}, {name: up, when: [Pose != 0]}]}
  Walk: {causing: [Pose == 0]}
)");
  machine.engine().set_most_decided_whole(most_decided_whole);
  machine.decisions = true;
  Lines all;
  const auto step = [&](Time now) {
    for (const std::string& line : machine.step(now)) all.push_back(line);
  };
  for (Time now = 0; now < 300'000; now += 100'000) {
    machine.request("Play");
    step(now);
    machine.request("Kick");
    machine.set("Pose", "2");
    step(now + 10'000);
  }
  return all;
}

TEST_CASE("a unit that relied on the push of another is decided again when that push is dropped") {
  const Lines followed = served_by_another(0);
  CHECK(followed == served_by_another(1'000));
  CHECK(std::count(followed.begin(), followed.end(), "push Walk for root>Kick") == 3);
}

/// The decisions in a scenario, with incremental passes and with whole ones.
struct Both {
  Lines followed, whole;
};

template <class Play>
Both play_both(const std::string& behaviour, Play&& play) {
  const auto lines_of = [&](Index most_decided_whole) {
    Machine machine(behaviour);
    machine.engine().set_most_decided_whole(most_decided_whole);
    machine.decisions = true;
    Lines all;
    play(machine, [&] {
      for (const std::string& line : machine.step()) all.push_back(line);
    });
    return all;
  };
  return {lines_of(0), lines_of(1'000)};
}

TEST_CASE("a unit that keeps a push because of another push is decided again when the other is replaced") {
  const Both both = play_both(R"(
behaviour: chained
language: 1
states: {Ball: {range: [0, 1], external: true}, Pose: {range: [0, 3]}}
roots: {Play: {}, Kick: {levels: {spare: {priority: 60}}}, Walk: {levels: {firm: {}, spare: {optional: true}}}}
groups:
  Play: {tasks: {Pass: {}}}
  Kick: {when: [Ball == 1]}
  Walk:
    providers:
      - {name: near, causing: [Ball == 1], packs: {all: {Turn: {}}}}
      - {name: far, needs: [Step], causing: [Ball == 0], packs: {all: {Step: {}}}}
  Step: {providers: [{name: alone, tasks: {Lean: {}}}, {name: both, needs: [Legs]}]}
  Pass: {when: [Ball <= 0], needs: [Legs]}
  Legs: {needs: [Foot]}
  Foot: {providers: [{name: set, when: [Pose == 3]}, {name: loose}]}
  Turn: {tasks: {Lean: {}}}
  Lean: {causing: [Pose >= 3]}
)",
                              [](Machine& machine, auto&& step) {
                                machine.request("Play");
                                step();
                                machine.request("Walk", "spare");
                                step();
                                machine.set("Ball", "0");
                                step();
                                machine.request("Walk", "firm");
                                step();
                                machine.request("Kick");
                                step();
                              });
  CHECK(both.followed == both.whole);
  CHECK(std::count(both.whole.begin(), both.whole.end(), "push Lean for Play>Pass") == 1);
  CHECK(std::count(both.whole.begin(), both.whole.end(), "release Lean") == 1);
}

TEST_CASE("a denial also counts for a task with another choice whose decision remains") {
  const Both both = play_both(R"(
behaviour: equals
language: 1
states: {Phase: {values: [off, low, high], external: true}}
roots: {Play: {}, Step: {}}
groups:
  Play:
    providers:
      - {name: usual, when: [Phase != off], tasks: {Walk: {}, Step: {}, Legs: {}, Dance: {apart: true}}}
      - {name: other, needs: [Dance]}
  Walk: {tasks: [Step]}
  Step: {providers: [{name: firm, needs: [Legs]}, {name: light, when: [Phase != high]}]}
  Dance: {needs: [Legs]}
  Legs: {}
)",
                              [](Machine& machine, auto&& step) {
                                machine.request("Play");
                                step();
                                machine.set("Phase", "low");
                                step();
                                machine.set("Phase", "off");
                                machine.request("Step");
                                machine.set("Phase", "high");
                                step();
                              });
  CHECK(both.followed == both.whole);
  CHECK(std::count(both.whole.begin(), both.whole.end(), "run Dance new_task") == 1);
}

TEST_CASE("groups of several components that one trigger runs do so in order, also without arbitration") {
  const Both both =
      play_both(R"(
behaviour: apart
language: 1
states: {Light: {values: [off, on], external: true}}
triggers: [Tick]
roots: {Lamp: {}, First: {}, Second: {}}
groups:
  Lamp: {when: [Light == on]}
  First: {tasks: {Arm: {}}}
  Arm: {triggers: [Tick]}
  Second: {tasks: {Head: {}}}
  Head: {triggers: [Tick]}
)",
                [](Machine& machine, auto&& step) {
                  bool requests = false;
                  machine.body("First", [&](Run& run) { return requests ? machine.everything(run) : run.pack(); });
                  for (const char* each : {"First", "Second", "Lamp"}) {
                    machine.request(each);
                    step();
                  }
                  requests = true;
                  machine.request("First"); // its task is requested later than that of the second one
                  step();
                  machine.set("Light", "on");
                  machine.fire("Tick");
                  step();
                });
  CHECK(both.followed == both.whole);
  CHECK(Lines(both.followed.end() - 2, both.followed.end()) == Lines{"run Arm trigger", "run Head trigger"});
}

TEST_CASE("a group that was an optional task, and is only needed since its requester stopped, is ordered by the need") {
  for (const Index most_decided_whole : {0U, 1'000U}) {
    Machine machine(R"(
behaviour: need
language: 1
roots: {Walk: {}, Play: {priority: 10}}
groups:
  Play: {needs: [Walk], tasks: {Look: {optional: true}}}
  Walk: {needs: [Legs], tasks: {Legs: {optional: true}}}
  Legs: {}
  Look: {}
)");
    machine.engine().set_most_decided_whole(most_decided_whole);
    machine.request("Walk");
    machine.step();
    machine.request("Play");
    machine.step();
    const State& memory = machine.engine().memory();
    Lines order;
    for (Index i = 0; i < memory.order_count[0]; ++i)
      order.push_back(machine.model().groups[compiler::GroupId{memory.order[i]}].name.value);
    CHECK(order == Lines{"Play", "Walk", "Legs", "Look"});
  }
}

TEST_CASE("a waiting task is blocked once the group that it needs is claimed earlier, as a need, by its holder") {
  for (const Index most_decided_whole : {0U, 1'000U}) {
    Machine machine(R"(
behaviour: earlier
language: 1
states:
  Grip: {values: [loose, firm], initial: loose, external: true}
  Door: {values: [shut, open], initial: shut, external: true}
roots: {Carry: {}}
groups:
  Carry: {needs: [Lift], tasks: {Wave: {priority: 20, apart: true}, Lift: {priority: 10, apart: true}}}
  Wave: {when: [Door == open], needs: [Arm]}
  Lift:
    providers:
      - {name: firmly, when: [Grip == firm], needs: [Arm]}
      - {name: loosely, tasks: [Arm]}
  Arm: {}
)");
    machine.engine().set_most_decided_whole(most_decided_whole);
    machine.request("Carry");
    machine.step();
    CHECK(machine.engine().holder(machine.group("Arm")) == machine.edge("Lift>Arm"));
    CHECK(machine.engine().queued(machine.edge("Carry>Wave")).why == Why::waiting);
    machine.set("Grip", "firm");
    machine.engine().set_budget(1); // not at rest
    machine.step();
    CHECK(machine.engine().holder(machine.group("Arm")) == machine.edge("Lift>Arm"));
    CHECK(machine.engine().queued(machine.edge("Carry>Wave")).why == Why::blocked);
  }
}

TEST_CASE("a group is denied to an edge that became the equal of its holder in a pass from nothing") {
  for (const Index most_decided_whole : {0U, 1'000U}) {
    Machine machine(R"(
behaviour: moved
language: 1
states: {Light: {values: [off, on], initial: off, external: true}}
roots: {Play: {priority: 10}, Help: {priority: 20}}
groups:
  Play: {tasks: {Aim: {apart: true}, Walk: {apart: true}}}
  Help: {tasks: [Walk]}
  Aim: {packs: {both: {Legs: {}, Camera: {}}}}
  Walk: {tasks: [Legs]}
  Camera: {when: [Light == on]}
  Legs: {}
)");
    machine.engine().set_most_decided_whole(most_decided_whole);
    machine.request("Play");
    machine.step();
    machine.request("Help");
    machine.step();
    machine.engine().forget_trail();
    machine.cancel("Help");
    machine.step();
    CHECK(machine.engine().holder(machine.group("Legs")) == machine.edge("Walk>Legs"));
    CHECK(machine.engine().queued(machine.edge("Aim>Legs")).why == Why::blocked);
  }
}

TEST_CASE("an engine that forgets its last pass decides the same from nothing") {
  Machine machine(player_in_a_crowd(12));
  machine.request("Crowd");
  machine.request("Walk");
  machine.step();
  machine.engine().forget_trail();
  machine.decisions = true;
  machine.set("Ball", "near");
  machine.request("Play");
  const Lines lines = machine.step();
  Machine other(player_in_a_crowd(12));
  other.request("Crowd");
  other.request("Walk");
  other.step();
  other.decisions = true;
  other.set("Ball", "near");
  other.request("Play");
  CHECK(lines == other.step());
}

} // namespace
} // namespace director::tests
