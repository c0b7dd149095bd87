// SPDX-License-Identifier: MIT
// Cells where a condition of the first task is lost.
#include "tests/compiler/transitions/cell.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace director::tests {

TEST_CASE("condition lost: the first one runs on without what it loses, or for another requester") {
  const std::string person = "states: {Person: {values: [near, none], initial: near, external: true}}\n";
  CHECK(cell_words(person + R"(roots: {Safety: {priority: 20}, Drive: {priority: 10}}
groups:
  Safety:
    providers:
      - {name: stopping, when: [Person == near], tasks: [Freeze]}
      - {name: watching}
  Freeze: {needs: [Wheels], tasks: [Wheels]}
  Drive: {when: [Person == none], needs: [Wheels], tasks: [Wheels]}
  Wheels: {}
)",
                   "Safety", "Drive") ==
        "condition lost: What Drive wants from outside ends groups below Safety, which "
        "runs on. Freeze stops. Wheels runs "
        "on, but not for Safety any more. From outside: Person == none.");
  CHECK(cell_words(person + R"(roots: [Stay, Go]
groups:
  Stay: {when: [Person == near], tasks: [Walk]}
  Go: {when: [Person == none], tasks: [Walk]}
  Walk: {needs: [Legs]}
  Legs: {}
)",
                   "Walk", "Go") ==
        "condition lost: What Go wants from outside ends Walk. Stay stops. Walk stops, and begins again, but not for "
        "Stay. From outside: Person == none.");
}

TEST_CASE("condition lost: what the second wants from outside ends the first one") {
  const char* const phases = R"(states: {Phase: {values: [ready, playing], initial: ready, external: true}}
roots: [Wait, Play]
groups:
  Wait: {when: [Phase == ready], needs: [Legs]}
  Play: {when: [Phase == playing], needs: [Head]}
  Legs: {}
  Head: {}
)";
  CHECK(cell(phases, "Wait", "Play") ==
        R"(condition lost: What Play wants from outside ends Wait. From outside: Phase == playing.
stops Wait
scenario: from Wait to Play
behaviour: test.yaml
script:
  Wait.default:
    - {reason: wait, done: true}
    - {wait: 1 ms}
steps:
  - request: Wait
  - inputs: [{set: {Phase: playing}}, {request: Play}]
)");
}

TEST_CASE("condition lost: the second one takes what is below the first one, which the outside has ended") {
  CHECK(cell_words(R"(states: {Ball: {values: [far, near], initial: far, external: true}}
roots: [Keep]
groups:
  Keep:
    providers:
      - {name: placing, when: [Ball == far], tasks: [Walk]}
      - {name: clearing, packs: {go: {Clear: {}}}}
  Clear: {packs: {go: {Walk: {optional: true}, Legs: {priority: 20, optional: true}}}}
  Walk: {tasks: [Legs]}
  Legs: {}
)",
                   "Walk", "Clear") ==
        "condition lost: By what Clear wants from outside, Walk runs on, but not for Keep any more. Legs runs on, but "
        "not for Walk any more. From outside: Ball == near.");
}

TEST_CASE("condition lost: a body of the second one sets what ends the first one, of which nothing is taken") {
  const auto walk = [](const std::string& sets, const std::string& guard = "Eye") {
    return cell_words(fmt::format(R"(states: {{Mode: {{values: [day, dusk, night], initial: day}}}}
roots: {{Walk: {{priority: 1}}, Guard: {{priority: 2}}}}
groups:
  Walk: {{when: [Mode == day], tasks: [Legs]}}
  Guard:
    providers:
      - {{name: look, sets: [{}], tasks: [{}]}}
      - {{name: calm, causing: [Mode == day within 1 s], tasks: [Eye]}}
  Legs: {{}}
  Eye: {{}}
)",
                                  sets, guard),
                      "Walk", "Guard");
  };
  CHECK(walk("Mode == dusk") == "condition lost: What Guard.look sets (Mode == dusk) ends Walk.");
  CHECK(walk("Mode == dusk", "Legs").starts_with("hard: Guard takes at once what Walk holds."));
  // It need not set one of several values.
  CHECK(walk("Mode == dusk|night") == "both: Walk and Guard run beside each other.");
}

TEST_CASE("condition lost: a promise that would undo the values from outside does not hide that") {
  CHECK(
      cell_words(R"(states: {Stability: {values: [fallen, moving, standing], initial: standing, external: true}}
roots: {Recover: {priority: 90}, Play: {priority: 10}}
groups:
  Recover:
    providers:
      - {name: up, when: [Stability == fallen], tasks: [GetUp]}
      - {name: fine}
  GetUp: {needs: [Legs], tasks: [Legs]}
  Play: {packs: {go: {Kick: {priority: 5}, Walk: {apart: true}}}}
  Kick: {when: [Stability == standing], stay: [Stability >= moving], needs: [Legs], tasks: [Legs]}
  Walk:
    providers:
      - {name: walking, needs: [Legs], tasks: [Legs]}
      - {name: halting, needs: [Legs], causing: [Stability == standing], tasks: [Legs]}
  Legs: {}
)",
                 "Kick", "GetUp") ==
      "condition lost: What GetUp wants from outside ends Kick. Kick stops. Legs stops, and begins again, but not for "
      "Kick. From outside: Stability == fallen.");
}

TEST_CASE("condition lost: the outside ends the provider that is preferred to the one that leads to the second one") {
  for (const char* const initial : {"away", "near"}) {
    CHECK(cell_words("states: {Penalty: {values: [away, near], initial: " + std::string(initial) + R"(, external: true}}
roots: [Keep]
groups:
  Keep:
    providers:
      - {name: penalty, when: [Penalty == near], tasks: [Dive]}
      - {name: placing, tasks: [Walk]}
  Dive: {needs: [Legs], tasks: [Legs]}
  Walk: {needs: [Legs], tasks: [Legs]}
  Legs: {}
)",
                     "Dive", "Walk") ==
          "condition lost: What Walk wants from outside ends Dive. Dive stops. Legs runs on, "
          "but not for Dive any more. From outside: Penalty == away.");
  }
}

TEST_CASE("condition lost: the outside ends several providers that are preferred to the one of the second one") {
  const auto keeper = [](const std::string& states, const std::string& first, const std::string& second) {
    return "states: " + states + "\nroots: [Keep]\ngroups:\n  Keep:\n    providers:\n      - {name: first, when: [" +
           first + "], tasks: [Dive]}\n      - {name: second, when: [" + second + R"(], tasks: [Kick]}
      - {name: placing, tasks: [Walk]}
  Dive: {needs: [Legs], tasks: [Legs]}
  Kick: {needs: [Legs], tasks: [Legs]}
  Walk: {needs: [Legs], tasks: [Legs]}
  Legs: {}
)";
  };
  const auto lost = [](const std::string& group, const std::string& state) {
    return "condition lost: What Walk wants from outside ends " + group + ". " + group +
           " stops. Legs runs on, but not for " + group + " any more. From outside: " + state + ".";
  };
  // A value that prevents one of them lets the other one run.
  const std::string modes = keeper("{Mode: {values: [a, b, c], initial: c, external: true}}", "Mode == b", "Mode == a");
  CHECK(cell_words(modes, "Dive", "Walk") == lost("Dive", "Mode == c"));
  CHECK(cell_words(modes, "Kick", "Walk") == lost("Kick", "Mode == c"));
  // Not both conditions of the first one can be made false with one of the second one.
  const std::string range = keeper("{Battery: {range: [0, 100], initial: 100, external: true}}",
                                   "Battery >= 20, Battery < 50", "Battery < 20");
  CHECK(cell_words(range, "Dive", "Walk") == lost("Dive", "Battery == 50"));
  CHECK(cell_words(range, "Kick", "Walk") == lost("Kick", "Battery == 50"));
}

TEST_CASE("condition lost: what is set from outside for the second is not undone by a push of the first one") {
  CHECK(cell(R"(
states: {Pose: {values: [moving, still, falling], initial: still, external: true}}
roots: {Recover: {priority: 90}, Play: {priority: 10}}
groups:
  Recover: {tasks: [Brace]}
  Brace: {when: [Pose == falling], needs: [Legs]}
  Play: {packs: {shoot: {Kick: {priority: 20, apart: true}, Walk: {priority: 10, apart: true}}}}
  Kick: {when: [Pose == still], needs: [Legs]}
  Walk:
    providers:
      - {name: walking, sets: [Pose == moving]}
      - {name: halting, causing: [Pose == still]}
  Legs: {}
)",
             "Kick", "Brace") ==
        R"(condition lost: What Brace wants from outside ends Kick. From outside: Pose == falling.
stops Kick
scenario: from Kick to Brace
behaviour: test.yaml
script:
  Recover.default:
    - {tasks: [Brace]}
  Play.default:
    - {reason: subtask_done, done: true}
    - {pack: shoot}
  Kick.default:
    - {reason: wait, done: true}
    - {wait: 1 ms}
  Walk.walking:
    - {run: 1, set: {Pose: moving}}
    - {}
  Walk.halting:
    - {run: 1, reason: pushed, set: {Pose: still}}
    - {reason: pushed}
    - {}
steps:
  - request: Play
  - inputs: [{set: {Pose: falling}}, {request: Recover}]
)");
}

TEST_CASE("condition lost: what comes behind the provider that leads to the second one is not kept from running") {
  CHECK(cell_words(R"(states: {Day: {values: [work, rest], external: true}}
roots: [Visit, Serve]
groups:
  Visit: {when: [Day == work], tasks: [Serve]}
  Serve:
    providers:
      - {name: selling, when: [Day == work]}
      - {name: cleaning, needs: [Broom], tasks: [Sweep]}
      - {name: resting, when: [Day == rest]}
  Sweep: {tasks: [Broom]}
  Broom: {}
)",
                   "Visit", "Sweep") ==
        "condition lost: What Sweep wants from outside ends Visit. Visit stops. Serve stops, and begins again, but not "
        "for Visit. From outside: Day == rest.");
}

TEST_CASE("condition lost: the second one does not undo by its own promise what it wants from outside") {
  CHECK(cell_words(R"(states: {Battery: {values: [low, full], initial: low, external: true}}
roots: {Work: {priority: 20}, Charge: {priority: 10}}
groups:
  Work: {when: [Battery == full], tasks: [Arm]}
  Charge: {when: [Battery == low], needs: [Arm], causing: [Battery == full]}
  Arm: {}
)",
                   "Work", "Charge") ==
        "condition lost: What Charge wants from outside ends Work. From outside: Battery == low.");
}

TEST_CASE("condition lost: the values end the provider that runs, and the first one begins again in another one") {
  CHECK(
      cell_words(R"(states:
  Stance: {values: [sitting, standing]}
  Intent: {values: [rise, go], external: true}
roots: [Wear]
groups:
  Wear:
    providers:
      - {name: walking, when: [Intent == go], packs: {go: {Gait: {}}}}
      - {name: resting, packs: {rest: {Relax: {priority: 10}, Gait: {apart: true}}}}
  Relax:
    providers:
      - {name: bending, when: [Stance == sitting], tasks: [Knees]}
      - {name: leaning}
  Gait:
    providers:
      - {name: striding, when: [Intent == go]}
      - {name: shuffling, needs: [Knees]}
  Knees: {}
)",
                 "Gait", "Relax") ==
      "condition lost: What Relax wants from outside ends Gait. Gait stops, and begins again. From outside: Intent == "
      "rise.");
}

} // namespace director::tests
