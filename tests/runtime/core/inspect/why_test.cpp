// SPDX-License-Identifier: MIT
// Why a group does not run, as a sentence: each kind of answer in one situation. tests/property compares answers with
// the oracle on random scenarios.

#include "runtime/core/inspect/why.hpp"
#include "tests/runtime/core/machine.hpp"

#include <catch2/catch.hpp>

namespace director::tests {
namespace {

const Machine& machine_at(const void* self) { return *static_cast<const Machine*>(self); }

const char* kept(std::string text) {
  static std::array<std::string, 8> ring;
  static std::size_t at = 0;
  return (ring[at++ % ring.size()] = std::move(text)).c_str();
}

std::string why(const Machine& machine, const std::string& group, std::size_t buffer_size = 300) {
  const Names names{
      .self = &machine,
      .group = [](const void* self,
                  Index row) { return kept(machine_at(self).model().groups[compiler::GroupId{row}].name.value); },
      .provider = [](const void* self,
                     Index row) { return kept(machine_at(self).model().providers[compiler::ProviderId{row}].name); },
      .edge = [](const void* self,
                 Index row) { return kept(machine_at(self).model().edge_name(compiler::EdgeId{row})); },
      .condition =
          [](const void* self, Index row) {
            const Condition& condition = machine_at(self).tables().conditions[row];
            const auto& state = machine_at(self).model().states[compiler::StateId{condition.state}];
            const auto low = machine_at(self).tables().intervals[condition.accepts.begin].low;
            return kept(state.name.value + " == " + state.value_text(low));
          },
  };
  std::string buffer(buffer_size, '?');
  return to_text(why(view_of(machine.engine()), machine.group(group)), names, buffer);
}

constexpr auto robot = R"(
behaviour: robot
language: 1
states:
  Stability: {values: [moving, standing], initial: moving, external: true}
  Ball: {values: [lost, near], initial: lost, external: true}
roots:
  Recover: {priority: 90}
  Play: {priority: 10}
  Wave: {priority: 10}
  Stretch: {priority: 10}
groups:
  Recover: {needs: [Legs], tasks: {Legs: {}}}
  Play: {tasks: {Walk: {priority: 1}, Kick: {priority: 2}, Look: {optional: true}, Whistle: {apart: true}}}
  Wave: {needs: [Arms], tasks: {Arms: {}}}
  Stretch: {tasks: {Arms: {}, Look: {}}}
  Walk:
    providers:
      - {name: striding, needs: [Legs], tasks: {Legs: {}}}
      - {name: halting, needs: [Legs], causing: [Stability == standing], tasks: {Legs: {}}}
  Kick: {when: [Stability == standing], needs: [Legs], tasks: {Legs: {}}}
  Look: {needs: [Head], tasks: {Head: {}}}
  Whistle: {when: [Ball == near], needs: [Head]}
  Legs: {}
  Arms: {}
  Head: {}
)";

TEST_CASE("for a running group the answer has its holder, and for one without a request that nothing requests it") {
  Machine machine(robot);
  CHECK(why(machine, "Legs") == "nothing requests Legs");
  machine.request("Recover");
  machine.step();
  CHECK(why(machine, "Legs") == "Legs runs (Recover>Legs)");
  CHECK(why(machine, "Recover") == "Recover runs (root>Recover)");
}

TEST_CASE("for a lost group the answer has the holder, the common requester, and the rule") {
  Machine machine(robot);
  machine.body("Play", [&](Run& run) {
    run.request(machine.edge("Play>Walk"), machine.level(machine.edge("Play>Walk")));
    return run.pack();
  });
  machine.request("Recover");
  machine.request("Play");
  machine.step();
  CHECK(why(machine, "Walk") ==
        "Walk waits (Play>Walk): Legs, which it needs, is held by Recover>Legs, and root>Recover "
        "(priority 90) goes before root>Play (priority 10)");
  CHECK(why(machine, "Walk", 20) == "Walk waits (Play>Wa");
}

TEST_CASE(
    "for a false condition the answer has the provider that could make it true, or that no enabled one promises it") {
  Machine machine(robot);
  machine.body("Walk.halting", [](Run& run) { return run.keep(); });
  machine.body("Play", [&](Run& run) {
    for (const char* edge : {"Play>Kick", "Play>Whistle"})
      run.request(machine.edge(edge), machine.level(machine.edge(edge)));
    return run.pack();
  });
  machine.request("Play");
  machine.step();
  CHECK(why(machine, "Kick") == "Kick waits (Play>Kick): until Stability == standing, which Walk.halting could cause");
  CHECK(why(machine, "Whistle") ==
        "Whistle waits (Play>Whistle): until Ball == near, which no enabled provider promises");
  machine.enable("Walk.halting", false);
  machine.step();
  CHECK(why(machine, "Kick") ==
        "Kick waits (Play>Kick): until Stability == standing, which no enabled provider promises");
}

TEST_CASE("equals do not take from each other, and a member of a unit has the condition that it waits for") {
  Machine machine(robot);
  machine.request("Wave");
  machine.step();
  machine.request("Stretch");
  machine.step();
  CHECK(why(machine, "Look") ==
        "Look waits (Stretch>Look): it comes with Stretch>Arms, and Arms is held by Wave>Arms, and root>Wave is the "
        "equal of root>Stretch (priority 10) and was there first");
}

TEST_CASE("an optional task goes after mandatory ones, with any priority") {
  Machine machine(robot);
  machine.body("Play", [&](Run& run) {
    run.request(machine.edge("Play>Look"), machine.level(machine.edge("Play>Look")));
    return run.pack();
  });
  machine.request("Stretch");
  machine.request("Play");
  machine.step();
  CHECK(view_of(machine.engine()).holding(machine.group("Look")).group == machine.group("Stretch"));
  CHECK(why(machine, "Play") == "Play runs (root>Play)");
  machine.cancel("Stretch");
  machine.step();
  CHECK(why(machine, "Look") == "Look runs (Play>Look)");
}

TEST_CASE("without an enabled provider, of the task or of what it needs, that is the reason") {
  Machine machine(robot);
  machine.enable("Legs", false);
  machine.request("Recover");
  machine.step();
  CHECK(why(machine, "Recover") == "Recover waits (root>Recover): no provider of Legs is enabled");
  machine.enable("Recover", false);
  machine.step();
  CHECK(why(machine, "Recover") == "Recover waits (root>Recover): no provider of Recover is enabled");
}

TEST_CASE("what could cause a condition is called like its group, if that has one provider without a name") {
  Machine machine(R"(
behaviour: pose
language: 1
states: {Pose: {values: [lying, standing], initial: lying}}
roots: [Kick]
groups:
  Kick: {when: [Pose == standing]}
  Stand: {causing: [Pose == standing]}
)");
  machine.request("Kick");
  machine.step();
  CHECK(why(machine, "Kick") == "Kick waits (root>Kick): until Pose == standing, which Stand could cause");
}

TEST_CASE("if what is enabled cannot be had together, the answer says that something is disabled") {
  Machine machine(R"(
behaviour: carrier
language: 1
roots: [Carry]
groups:
  Carry: {needs: [Lift, Arm]}
  Lift: {providers: [{name: fork, needs: [Fork]}, {name: arm, needs: [Arm]}]}
  Fork: {}
  Arm: {}
)");
  machine.enable("Lift.fork", false);
  machine.request("Carry");
  machine.step();
  CHECK(why(machine, "Carry") ==
        "Carry waits (root>Carry): with what is disabled, what it takes cannot be had together");
  machine.enable("Lift.arm", false);
  machine.step();
  CHECK(why(machine, "Carry") == "Carry waits (root>Carry): no provider of Lift is enabled");
}

TEST_CASE("a group that is needed and was not requested is reserved") {
  Machine machine(robot);
  machine.body("Recover", [](Run& run) { return run.keep(); });
  machine.request("Recover");
  machine.step();
  CHECK(why(machine, "Legs") == "Legs is held for a need (Recover>Legs), and is not requested");
  const Holding holding = view_of(machine.engine()).holding(machine.group("Legs"));
  CHECK(holding == Holding{Holding::By::group, machine.group("Recover"), machine.edge("Recover>Legs"), false});
  CHECK(view_of(machine.engine()).holding(machine.group("Recover")).by == Holding::By::program);
  CHECK(view_of(machine.engine()).holding(machine.group("Arms")) == Holding{});
}

TEST_CASE("tasks of one unit that need the same group block each other") {
  Machine machine(R"(
behaviour: pair
language: 1
roots: {Both: {}}
groups:
  Both: {tasks: {Left: {}, Right: {}}}
  Left: {needs: [Hand]}
  Right: {needs: [Hand]}
  Hand: {}
)");
  machine.request("Both");
  machine.step();
  CHECK(why(machine, "Left") == "Left waits (Both>Left): it and the other tasks of its unit cannot all be granted");
}

TEST_CASE("what a unit takes is held before anything below its members is tried, whatever its rank") {
  Machine machine(R"(
behaviour: striker
language: 1
roots: [Play]
groups:
  Play: {needs: [Arm], tasks: {Aim: {priority: 10}, Walk: {priority: 1}}}
  Aim: {tasks: {Kick: {}, Wave: {apart: true}, Run: {apart: true}}}
  Walk: {needs: [Legs], tasks: [Legs]}
  Kick: {needs: [Legs]}
  Wave: {needs: [Arm]}
  Run: {tasks: {Walk: {}}}
  Legs: {}
  Arm: {}
)");
  machine.body("Aim", [&](Run& run) {
    for (const char* edge : {"Aim>Kick", "Aim>Wave"})
      run.request(machine.edge(edge), machine.level(machine.edge(edge)));
    return run.pack();
  });
  machine.request("Play");
  machine.step();
  CHECK(why(machine, "Kick") == "Kick waits (Aim>Kick): Legs, which it needs, is held by Walk>Legs, and Play>Walk is "
                                "granted together with Play>Aim, which is above it");
  CHECK(why(machine, "Wave") ==
        "Wave waits (Aim>Wave): Arm, which it needs, is held by Play>Arm, which Play needs itself");
}

TEST_CASE("a group that was got as a need has the rank of what needs it, even if it is requested as optional too") {
  Machine machine(R"(
behaviour: looker
language: 1
roots: {Walk: {priority: 10}, Look: {priority: 20, optional: true}}
groups:
  Walk: {needs: [Head], tasks: {Head: {optional: true}}}
  Look: {needs: [Head]}
  Head: {}
)");
  machine.request("Walk");
  machine.request("Look");
  machine.step();
  CHECK(
      why(machine, "Look") ==
      "Look waits (root>Look): Head, which it needs, is held by Walk>Head, and root>Look is optional, or leads through "
      "something optional, unlike root>Walk");
}

TEST_CASE("a member of a unit goes before a task that is apart by the priority of the unit's first member") {
  Machine machine(R"(
behaviour: packing
language: 1
roots: {Pack: {}}
groups:
  Pack: {tasks: {Lift: {priority: 50}, Sort: {priority: 20, apart: true}, Grip: {priority: 0}}}
  Lift: {}
  Sort: {needs: [Grip]}
  Grip: {needs: [Finger]}
  Finger: {}
)");
  machine.request("Pack");
  machine.step();
  CHECK(why(machine, "Sort") ==
        "Sort waits (Pack>Sort): Grip, which it needs, is held by Pack>Grip, and Pack>Grip (granted together with "
        "Pack>Lift, priority 50) goes before Pack>Sort (priority 20)");
}

TEST_CASE("the equal of a member keeps what it has, though the unit of the member goes before it") {
  Machine machine(R"(
behaviour: packing
language: 1
states: {Weight: {values: [low, high], initial: low, external: true}}
roots: {Pack: {}}
groups:
  Pack: {tasks: {Sort: {apart: true}, Lift: {priority: 10}, Grip: {}, Weigh: {}}}
  Sort: {tasks: [Grip]}
  Lift: {}
  Grip: {}
  Weigh: {when: [Weight == high]}
)");
  machine.request("Pack");
  machine.step();
  CHECK(why(machine, "Lift") == "Lift waits (Pack>Lift): it comes with Pack>Grip, and Grip is held by Sort>Grip, and "
                                "Pack>Sort is the equal of Pack>Grip (priority 0) and was there first");
}

TEST_CASE("an equal that got what was left, and as an optional task would not keep it, is not in the way") {
  Machine machine(R"(
behaviour: looker
language: 1
roots: {Both: {}, Look: {}}
groups:
  Both: {tasks: {Left: {}, Head: {}}}
  Left: {needs: [Head]}
  Look: {needs: [Head], tasks: {Head: {optional: true}}}
  Head: {}
)");
  machine.request("Both");
  machine.request("Look");
  machine.step();
  CHECK(why(machine, "Left") == "Left waits (Both>Left): it and the other tasks of its unit cannot all be granted");
}

TEST_CASE("of several requests made at once the answer is about the one below the sibling that is declared first") {
  Machine machine(R"(
behaviour: twice
language: 1
roots: {Boss: {priority: 1}, Guard: {priority: 5}}
groups:
  Boss: {tasks: {Late: {apart: true}, Early: {apart: true}}}
  Early: {tasks: {Legs: {}}}
  Late: {tasks: {Legs: {}}}
  Guard: {needs: [Legs]}
  Legs: {}
)");
  machine.request("Guard");
  machine.request("Boss");
  machine.step();
  CHECK(why(machine, "Legs") ==
        "Legs waits (Late>Legs): Legs is held by Guard>Legs, and root>Guard (priority 5) goes before root>Boss "
        "(priority 1)");
}

TEST_CASE("a request is not ordered by the unit above it, even if its group is held as a need") {
  Machine machine(R"(
behaviour: packing
language: 1
roots: {Boss: {priority: 1}, Guard: {priority: 5}}
groups:
  Boss: {tasks: {Lift: {priority: 50}, Sort: {priority: 20, apart: true}, Grip: {priority: 0}}}
  Lift: {}
  Grip: {tasks: {Finger: {}}}
  Sort: {tasks: {Finger: {}}}
  Guard: {needs: [Finger]}
  Finger: {}
)");
  machine.body("Guard", [](Run& run) { return run.keep(); });
  machine.request("Guard");
  machine.request("Boss");
  machine.step();
  CHECK(why(machine, "Finger") ==
        "Finger waits (Sort>Finger): Finger is held by Guard>Finger, and root>Guard (priority 5) goes before root>Boss "
        "(priority 1)");
}

TEST_CASE("a condition is that of the first provider whose groups are available, and not of another one") {
  Machine machine(R"(
behaviour: robot
language: 1
states: {Ball: {values: [far, near], initial: far, external: true}}
roots: [Play]
groups:
  Play: {packs: {go: {Look: {}, Kick: {}}}}
  Look: {providers: [{name: around}, {name: down, when: [Ball == near]}]}
  Kick: {when: [Ball == near]}
)");
  machine.request("Play");
  machine.step();
  CHECK(why(machine, "Look") ==
        "Look waits (Play>Look): it comes with Play>Kick, and until Ball == near, which no enabled provider promises");
  CHECK(why(machine, "Kick") == "Kick waits (Play>Kick): until Ball == near, which no enabled provider promises");
}

TEST_CASE("the place of a condition is in the provider that waits, not in one whose groups are held") {
  Machine machine(R"(
behaviour: robot
language: 1
states:
  Ball: {values: [far, near], initial: far}
  Heat: {values: [low, high], initial: low, external: true}
roots: {Hold: {priority: 30}, Look: {priority: 20}, Bring: {priority: 10}}
groups:
  Hold: {needs: [Legs]}
  Look:
    providers:
      - {name: running, when: [Ball == near, Heat == high], needs: [Legs]}
      - {name: standing, when: [Ball == near]}
  Bring: {providers: [{name: resting}, {name: fetching, causing: [Ball == near]}]}
  Legs: {}
)");
  machine.body("Bring.fetching", [](Run& run) { return run.keep(); });
  for (const char* task : {"Hold", "Bring", "Look"}) machine.request(task);
  machine.step();
  const Because because = why(view_of(machine.engine()), machine.group("Look"));
  REQUIRE(because.kind == Because::Kind::condition);
  CHECK(machine.model().providers[compiler::ProviderId{because.provider}].name == "standing");
}

TEST_CASE("of several providers that could make a condition true the answer has the one that is pushed") {
  Machine machine(R"(
behaviour: robot
language: 1
states: {Ball: {values: [far, near], initial: far}}
roots: {Look: {priority: 20}, Bring: {priority: 10}}
groups:
  Look: {when: [Ball == near], causing: [Ball == near]}
  Bring: {providers: [{name: resting}, {name: fetching, causing: [Ball == near]}]}
)");
  machine.body("Bring.fetching", [](Run& run) { return run.keep(); });
  machine.request("Look");
  machine.request("Bring");
  machine.step();
  CHECK(why(machine, "Look") == "Look waits (root>Look): until Ball == near, which Bring.fetching could cause");
}

TEST_CASE("between micro-steps the answer has the group that is about to run, and limbo") {
  Machine machine(R"(
behaviour: heirs
language: 1
roots: {Old: {priority: 1}, New: {priority: 2}}
groups:
  Old: {needs: [Plan], tasks: {Plan: {}, Go: {}}}
  New: {needs: [Plan], tasks: {Plan: {}, Go: {}}}
  Plan: {}
  Go: {tasks: {Feet: {}}}
  Feet: {}
)");
  machine.request("Old");
  machine.step();
  machine.request("New");
  machine.engine().set_budget(1);
  machine.step();
  CHECK(why(machine, "Go") == "Go goes on without a request: it is kept for what is about to request it");
  CHECK(why(machine, "Feet").find("runs") != std::string::npos);
}

} // namespace
} // namespace director::tests
