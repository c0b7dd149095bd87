// SPDX-License-Identifier: MIT
// Cells where the second task takes what the first one holds.
#include "tests/compiler/transitions/cell.hpp"

#include <catch2/catch.hpp>

namespace director::tests {

TEST_CASE("hard: the second takes what the first one holds, and no group is pushed") {
  const char* const plain = R"(roots: {GetUp: {priority: 20}, Walk: {priority: 10}}
groups: {GetUp: {needs: [Legs]}, Walk: {needs: [Legs], tasks: [Legs]}, Legs: {}}
)";
  CHECK(cell(plain, "Walk", "GetUp") == R"(hard: GetUp takes at once what Walk holds. Walk and Legs stop.
stops Walk Legs
scenario: from Walk to GetUp
behaviour: test.yaml
script:
  Walk.default:
    - {reason: wait, done: true}
    - {tasks: [Legs], wait: 1 ms}
steps:
  - request: Walk
  - request: GetUp
)");
}

TEST_CASE("hard, soft: the second runs at once, and what is requested with it takes over") {
  const std::string pack = R"(states: {Pose: {values: [moving, still], initial: still}}
roots: {Guard: {priority: 20}, Walk: {priority: 10}}
groups:
  Guard: {packs: {act: {Stand: {priority: 6}, Grab: {apart: true, priority: 2}}}}
  Walk:
    providers:
      - {name: walking, needs: [Legs], sets: [Pose == moving], tasks: [Legs]}
      - {name: halting, needs: [Legs], causing: [Pose == still within 2 s], tasks: [Legs]}
  Grab: {needs: [Hand]}
  Hand: {}
  Legs: {}
)";
  const auto words = [&](const std::string& stand) {
    const std::string all = cell(pack + stand, "Walk", "Grab");
    return all.substr(0, all.find('\n'));
  };
  CHECK(words("  Stand: {needs: [Legs]}\n") ==
        "hard: Stand, which is requested with Grab, takes at once what Walk holds. Walk and Legs stop.");
  CHECK(words("  Stand: {when: [Pose == still], needs: [Legs]}\n") ==
        "soft: Grab runs at once. What is requested with it waits. Walk is pushed to halting for Pose == still, within "
        "2 s. Then Stand, which is requested with Grab, takes over. Walk and Legs stop.");
}

TEST_CASE("hard: up to seven groups that stop are named, of more the first six") {
  const auto robot = [](const std::string& tasks, const std::string& groups) {
    return "roots: {GetUp: {priority: 20}, Walk: {priority: 10}}\ngroups: {GetUp: {needs: [Legs]}, Walk: {needs: "
           "[Legs], "
           "tasks: [" +
           tasks + "]}, Legs: {}" + groups + "}\n";
  };
  CHECK(cell_words(robot("A, B, C, D, E, F", ", A: {}, B: {}, C: {}, D: {}, E: {}, F: {}"), "Walk", "GetUp") ==
        "hard: GetUp takes at once what Walk holds. Walk, A, B, C, D, E and F stop.");
  CHECK(cell_words(robot("A, B, C, D, E, F, G", ", A: {}, B: {}, C: {}, D: {}, E: {}, F: {}, G: {}"), "Walk",
                   "GetUp") == "hard: GetUp takes at once what Walk holds. Walk, A, B, C, D, E and 2 more stop.");
}

TEST_CASE("hard: what leads to the first one stops too, and is named where only it held what is taken") {
  const char* const above = R"(roots: {Guard: {priority: 10}, Plan: {priority: 1}}
groups:
  Guard: {needs: [Arm], tasks: [Arm]}
  Plan: {stop: true, needs: [Arm], tasks: [Arm, Think]}
  Think: {tasks: [Note]}
  Note: {}
  Arm: {}
)";
  CHECK(cell_words(above, "Think", "Guard") ==
        "hard: Guard takes at once what Plan, which leads to Think, holds. Plan, Think and Note stop.");
  const char* const below = R"(roots: {Guard: {priority: 10}, Plan: {priority: 1}}
groups:
  Guard: {needs: [Arm, Leg], tasks: [Arm]}
  Plan: {needs: [Leg], tasks: [Grip]}
  Grip: {needs: [Arm], tasks: [Arm]}
  Arm: {}
  Leg: {}
)";
  CHECK(cell_words(below, "Grip", "Guard") ==
        "hard: Guard takes at once what Grip holds. Plan and Grip stop. Arm runs on, but not for Grip any more.");
}

TEST_CASE("hard: what has stopped is not said to run, while a need holds it by the same edge") {
  const char* const held = R"(roots: {Boss: {priority: 10}, Old: {priority: 5}}
groups:
  Boss: {needs: [Old], tasks: {Aim: {}}}
  Old: {tasks: [Wheel], needs: [Wheel]}
  Aim: {tasks: [Lamp]}
  Wheel: {stop: true, needs: [Motor]}
  Motor: {}
  Lamp: {}
)";
  CHECK(cell_words(held, "Wheel", "Boss") == "hard: Boss takes at once what Wheel holds. Old and Wheel stop.");
  CHECK(cell_words(held, "Wheel", "Aim") == "hard: Aim takes at once what Wheel holds. Old and Wheel stop.");
}

TEST_CASE("hard: the group of the row itself is taken, and runs on, but not for its requester") {
  const char* const shared = R"(roots: {Boss: {priority: 10}, Guard: {priority: 50}}
groups:
  Boss: {tasks: [Look]}
  Guard: {tasks: [Look]}
  Look: {needs: [Eyes], tasks: [Eyes]}
  Eyes: {}
)";
  const std::string all = cell(shared, "Look", "Guard");
  CHECK(all.substr(0, all.find('\n')) ==
        "hard: Guard takes at once what Look holds. Look and Eyes run on, but not for Boss any more.");
}

TEST_CASE("hard: the values let the requester request both, and the second one takes what is below the first one") {
  CHECK(cell_words(R"(states: {Ball: {values: [far, near], initial: far, external: true}}
roots: [Keep]
groups:
  Keep:
    providers:
      - {name: placing, when: [Ball == far], tasks: [Place]}
      - {name: clearing, packs: {go: {Clear: {priority: 20, apart: true}, Place: {}}}}
  Clear: {needs: [Legs]}
  Place: {tasks: [Walk]}
  Walk: {needs: [Legs]}
  Legs: {}
)",
                   "Place",
                   "Clear") == "hard: Clear takes at once what Place holds. Walk stops. From outside: Ball == near.");
}

TEST_CASE(
    "hard: the requester has another provider for the second one, but goes on requesting both in that of the first") {
  CHECK(cell_words(R"(states:
  Ball: {values: [far, near], initial: far, external: true}
  Phase: {values: [play, set], initial: set, external: true}
roots: [Keep]
groups:
  Keep:
    providers:
      - {name: waiting, when: [Phase == set], tasks: [Clear]}
      - {name: playing, packs: {go: {Walk: {apart: true}, Clear: {priority: 5, apart: true}}}}
  Clear: {when: [Ball == near], needs: [Legs], tasks: [Legs]}
  Walk: {needs: [Legs], tasks: [Legs]}
  Legs: {}
)",
                   "Walk", "Clear") ==
        "hard: Clear takes at once what Walk holds. Walk stops. Legs runs on, but not for "
        "Walk any more. From outside: Ball == near.");
}

TEST_CASE("hard: what is requested with the second one takes all at once, and is pushed itself") {
  const std::string down = R"(states: {Air: {values: [flying, hover], initial: flying}}
roots: {Safety: {priority: 100}, Survey: {priority: 10}}
groups:
  Safety: {packs: {down: {Land: {priority: 5}, Fly: {apart: true}}}}
  Survey: {tasks: [TakeOff]}
  TakeOff: {needs: [Rotors], sets: [Air == flying], tasks: [Rotors], stop: true}
  Land: {when: [Air == hover], needs: [Rotors], tasks: [Rotors]}
  Fly:
    providers:
      - {name: cruise, needs: [Rotors], sets: [Air == flying], tasks: [Rotors]}
      - {name: brake, needs: [Rotors], causing: [Air == hover within 4 s], tasks: [Rotors]}
  Rotors: {}
)";
  CHECK(cell_words(down, "TakeOff", "Land") ==
        "hard: Fly, which is requested with Land, takes at once what TakeOff holds. TakeOff stops. Rotors runs on, but "
        "not for TakeOff any more.");
  CHECK(
      cell_words(down, "TakeOff", "Safety") ==
      "hard: Fly, which runs for Safety, takes at once what TakeOff holds. TakeOff stops. Rotors runs on, but not for "
      "TakeOff any more.");
}

TEST_CASE("hard: the second one itself takes what the first one holds, as it is pushed") {
  CHECK(cell_words(R"(states: {Light: {values: [dark, lit], initial: dark}}
roots: {Record: {priority: 10}, Focus: {}}
groups:
  Record: {packs: {film: {Film: {priority: 10}, Lamp: {apart: true}}}}
  Film: {when: [Light == lit]}
  Focus: {tasks: [Led]}
  Lamp: {needs: [Led], causing: [Light == lit within 200 ms]}
  Led: {}
)",
                   "Focus", "Lamp") == "hard: Lamp takes at once what Focus holds. Led stops.");
}

TEST_CASE("hard: what the first one holds for a need only is taken, and it goes on in another provider") {
  const auto needs = [](int priority) {
    return fmt::format(R"(roots: {{Carry: {{priority: 10}}, Wave: {{priority: {}}}}}
groups:
  Carry:
    providers:
      - {{name: with_both, needs: [LeftArm, RightArm]}}
      - {{name: with_left, needs: [LeftArm]}}
  Wave: {{needs: [RightArm]}}
  LeftArm: {{}}
  RightArm: {{}}
)",
                       priority);
  };
  CHECK(cell_words(needs(20), "Carry", "Wave") ==
        "hard: Wave takes at once what Carry holds. Carry goes on in with_left.");
  CHECK(cell_words(needs(5), "Carry", "Wave").starts_with("waits: "));
}

TEST_CASE(
    "both: what the first one held for a need is free, as its own condition has ended the provider that held it") {
  CHECK(cell_words(R"(states: {Load: {values: [heavy, light], initial: heavy, external: true}}
roots: {Carry: {priority: 20}, Wave: {priority: 10}}
groups:
  Carry:
    providers:
      - {name: with_both, when: [Load == heavy], needs: [LeftArm, RightArm]}
      - {name: with_left, needs: [LeftArm]}
  Wave: {when: [Load == light], needs: [RightArm]}
  LeftArm: {}
  RightArm: {}
)",
                   "Carry", "Wave") == "both: Carry and Wave run beside each other. From outside: Load == light.");
}

TEST_CASE("hard: what is requested with the second one too has another requester before the push is answered") {
  const auto talk = [](const char* when) {
    return fmt::format(R"(states: {{Motion: {{values: [still, rolling], initial: still}}}}
roots: {{Tour: {{priority: 10}}, Deliver: {{priority: 20}}}}
groups:
  Tour: {{packs: {{go: {{Drive: {{priority: 5}}, Talk: {{apart: true}}}}}}}}
  Deliver: {{packs: {{give: {{HandOver: {{priority: 5}}, Drive: {{apart: true}}, Talk: {{apart: true}}}}}}}}
  HandOver: {{{}needs: [Wheels], tasks: [Wheels]}}
  Drive:
    providers:
      - {{name: rolling, needs: [Wheels], sets: [Motion == rolling], tasks: [Wheels]}}
      - {{name: braking, needs: [Wheels], causing: [Motion == still within 3 s], tasks: [Wheels]}}
  Talk: {{needs: [Speaker], tasks: [Speaker]}}
  Speaker: {{}}
  Wheels: {{}}
)",
                       when);
  };
  constexpr std::string_view words = "hard: Deliver, which leads to HandOver, takes at once what Talk holds. Talk and "
                                     "Speaker run on, but not for Tour any more.";
  CHECK(cell_words(talk(""), "Talk", "HandOver") == words);
  CHECK(cell_words(talk("when: [Motion == still], "), "Talk", "HandOver") == words);
}

TEST_CASE("hard, soft: what the first one runs for is requested with the second one too, and runs on") {
  const char* const text = R"(states: {Stability: {values: [moving, standing], initial: moving}}
roots: {Gaze: {priority: 5}, Game: {priority: 10}}
groups:
  Game: {packs: {go: {Kick: {priority: 5}, Walk: {apart: true}, LookAt: {apart: true}}}}
  Gaze: {tasks: [LookAt]}
  LookAt: {needs: [Head], tasks: [Head]}
  Kick: {when: [Stability == standing], needs: [Legs], tasks: [Legs]}
  Walk:
    providers:
      - {name: walking, needs: [Legs], sets: [Stability == moving], tasks: [Legs]}
      - {name: halting, needs: [Legs], causing: [Stability == standing within 2 s], tasks: [Legs]}
  Legs: {}
  Head: {}
)";
  for (const char* const first : {"LookAt", "Gaze"}) {
    CHECK(cell_words(text, first, "Kick") == fmt::format("hard: Game, which leads to Kick, takes at once what {} "
                                                         "holds. LookAt and Head run on, but not for Gaze any more.",
                                                         first));
  }
}

} // namespace director::tests
