// SPDX-License-Identifier: MIT
// How a row and a column begin, and what is set for that.
#include "compiler/lower/lower.hpp"
#include "compiler/transitions/matrix.hpp"
#include "tests/compiler/support/compiled.hpp"
#include "tests/compiler/transitions/cell.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace director::tests {

namespace {

using compiler::TransitionMatrix;

} // namespace

TEST_CASE("the name of the behaviour is quoted in scenarios where YAML reads it in another way") {
  const Compiled compiled = compile(std::string("behaviour: test\nlanguage: 1\n") + legs);
  for (const auto& [file, written] :
       {std::pair("a #c.yaml", "\"a #c.yaml\""), std::pair(" lead.yaml", "\" lead.yaml\""),
        std::pair("left arm.yaml", "left arm.yaml")}) {
    const TransitionMatrix matrix = compiler::find_transitions(compiled.model, compiler::lower(compiled.model), file);
    CHECK(matrix.pieces[matrix.rows.at(0).cells.at(1).scenario.at(4)] == fmt::format("\nbehaviour: {}\n", written));
  }
}

TEST_CASE("a matrix whose plays take too long is left out, with what to do") {
  const Compiled compiled = compile(std::string("behaviour: test\nlanguage: 1\n") + legs);
  const compiler::Lowered lowered = compiler::lower(compiled.model);
  const TransitionMatrix all = compiler::find_transitions(compiled.model, lowered, "test.yaml");
  CHECK(all.left_out.empty());
  const TransitionMatrix none = compiler::find_transitions(compiled.model, lowered, "test.yaml", {}, 1);
  CHECK(none.left_out == fmt::format("The transition matrix is left out: playing all {} of its cells would take too "
                                     "long. `directorc docs --transitions GROUP,GROUP` plays it for some groups.",
                                     all.rows.size() * all.rows.size()));
  CHECK(none.rows.empty());
  CHECK(none.pieces.empty());
}

TEST_CASE("names that YAML reads in another way are quoted in scenarios") {
  const std::string names = R"(states: {"On": {values: ["yes", "no"], initial: "no", external: true}}
roots: {"No": {priority: 2}, "Yes": {priority: 1}}
groups:
  "No": {providers: [{name: "y", when: ["On == yes"], needs: [Legs], packs: {"n": ["True"]}}]}
  "Yes": {providers: [{name: "on", needs: [Legs], tasks: [Legs]}]}
  "True": {}
  Legs: {}
)";
  CHECK(cell_words(names, "Yes", "No") ==
        "hard: No takes at once what Yes holds. Yes and Legs stop. From outside: On == yes.");
}

TEST_CASE("a row begins with declared values if it can, also where no body sets one of several values then") {
  const std::string trip = R"(states: {Mood: {values: [ok, sad, glad], initial: ok}}
roots: {Trip: {priority: 1}, Party: {priority: 2}, Guard: {priority: 3}}
groups:
  Trip:
    providers:
      - {name: down, when: [Mood == sad|glad], tasks: [Rest]}
      - {name: go, tasks: [Note, Work]}
  Party:
    providers:
      - {name: dance, when: [Mood == glad], tasks: [Work]}
      - {name: idle, tasks: [Rest]}
  Work:
    providers:
      - {name: hard, when: [Mood != glad], sets: [Mood == sad|glad], needs: [Arm], tasks: [Arm]}
      - {name: light, causing: [Mood == ok within 1 s]}
  Note: {}
  Guard: {tasks: [Note]}
  Rest: {}
  Arm: {}
)";
  CHECK(row_words(trip, "Work") == "Requested by way of Trip \u2192 Work.");
  CHECK(cell_words(trip, "Guard", "Work") == "both: Guard and Work run beside each other.");
}

TEST_CASE("a row is not called unreachable while values of another provider that it may use let it run") {
  const char* const climbing = R"(states: {Ground: {values: [flat, rough], initial: flat, external: true}}
roots: {Climb: {priority: 20}, Rest: {priority: 10}}
groups:
  Climb: {when: [Ground == rough], needs: [Move], tasks: [Move]}
  Move:
    providers:
      - {name: rolling, when: [Ground == flat]}
      - {name: stepping, when: [Ground == rough]}
  Rest: {needs: [Move], tasks: [Move]}
)";
  CHECK(cell_words(climbing, "Rest", "Climb") ==
        "hard: Climb takes at once what Rest holds. Rest stops. Move runs on, but "
        "not for Rest any more. From outside: Ground == rough.");
}

TEST_CASE("a row is not called unreachable while values for the other tasks of its unit let it run") {
  const char* const delivery = R"(states: {Door: {values: [closed, open], initial: closed, external: true}}
roots: {Deliver: {priority: 20}, Rest: {priority: 10}}
groups:
  Deliver: {packs: {go: {Drive: {}, Enter: {}}}}
  Drive: {needs: [Wheels], tasks: [Wheels]}
  Enter: {when: [Door == open]}
  Rest: {needs: [Wheels], tasks: [Wheels]}
  Wheels: {}
)";
  CHECK(cell_words(delivery, "Rest", "Drive") ==
        "hard: Drive takes at once what Rest holds. Rest stops. Wheels runs on, "
        "but not for Rest any more. From outside: Door == open.");
}

TEST_CASE("what the second waits for is set by a body of its requester, if it would never run otherwise") {
  const std::string travel = R"(states:
  Leg: {values: [going, looking], initial: going, of: Trip}
  Pose: {values: [moving, still], initial: still}
roots: [Trip]
groups:
  Trip:
    providers:
      - {name: going, when: [Leg == going], sets: [Leg == looking], packs: {go: {Walk: {}}}}
      - {name: looking, when: [Leg == looking], packs: {look: {Film: {priority: 1}, Walk: {apart: true}}}}
  Film: {when: [Pose == still], needs: [Eye]}
  Walk:
    providers:
      - {name: walking, needs: [Legs], sets: [Pose == moving], tasks: [Legs]}
      - {name: halting, needs: [Legs], causing: [Pose == still within 2 s], tasks: [Legs]}
  Eye: {}
  Legs: {}
)";
  CHECK(
      cell(travel, "Walk", "Film") ==
      R"(both: Walk and Film run beside each other. Walk is pushed to halting for Pose == still, within 2 s. Trip.going sets Leg == looking.
push Walk.halting for Pose == still within 2000000
scenario: from Walk to Film
behaviour: test.yaml
script:
  Trip.going:
    - {reason: subtask_done, continue: true}
    - {run: 1, pack: go}
    - {set: {Leg: looking}, pack: go}
  Trip.looking:
    - {pack: look}
  Walk.walking:
    - {reason: wait, done: true}
    - {set: {Pose: moving}, tasks: [Legs], wait: 1 ms}
  Walk.halting:
    - {reason: wait, done: true}
    - {reason: pushed, set: {Pose: still}, tasks: [Legs], wait: 1 ms}
    - {tasks: [Legs], wait: 1 ms}
steps:
  - request: Trip
  - request: Trip
)");
}

TEST_CASE("that a body sets what the second waits for is said only of bodies that did so") {
  CHECK(cell_words(R"(states:
  Leg: {values: [going, looking, lost], initial: going, of: Trip}
  Pose: {values: [moving, still], initial: still}
roots: [Trip]
groups:
  Trip:
    providers:
      - {name: lost, when: [Leg == lost], sets: [Leg == looking], packs: {go: {Walk: {}}}}
      - {name: going, when: [Leg == going], sets: [Leg == looking|lost], packs: {go: {Walk: {}}}}
      - {name: looking, when: [Leg == looking], packs: {look: {Film: {priority: 1}, Walk: {apart: true}}}}
  Film: {when: [Pose == still], needs: [Eye]}
  Walk:
    providers:
      - {name: walking, needs: [Legs], sets: [Pose == moving], tasks: [Legs]}
      - {name: halting, needs: [Legs], causing: [Pose == still within 2 s], tasks: [Legs]}
  Eye: {}
  Legs: {}
)",
                   "Walk", "Film") ==
        "both: Walk and Film run beside each other. Walk is pushed to halting for Pose == still, within 2 s. "
        "Trip.going sets Leg == looking.");
}

TEST_CASE("unreachable: no body sets the value that it wants") {
  const auto pose = [](const std::string& provider) {
    return "states: {Pose: {values: [down, up, high], initial: down}}\nroots: {A: {priority: 2}, D: {priority: 1}}\n"
           "groups:\n  A: {when: [Pose == up], needs: [Legs]}\n  D: {needs: [Legs], " +
           provider + "}\n  Legs: {}\n";
  };
  const std::string waits = "A waits (root>A): until Pose == up, which no enabled provider promises.";
  CHECK(row_words(pose(""), "A") == waits);
  CHECK(cell_words(pose(""), "A", "D") == "unreachable: A is not made to run.");
  CHECK(row_words(pose("sets: [Pose == high]"), "A") == waits);
  CHECK(row_words(pose("sets: [Pose == up|high]"), "A") ==
        "Requested by way of A. It begins with Pose == up, which only bodies set.");
}

TEST_CASE("unreachable: it never gets what it needs") {
  const char* const lost = R"(roots: [Walk, Play]
groups:
  Walk: {needs: [Legs]}
  Play:
    packs:
      all: {Throw: {priority: 2, apart: true}, Catch: {priority: 1, apart: true}}
  Throw: {needs: [Arm]}
  Catch: {needs: [Arm]}
  Legs: {}
  Arm: {}
)";
  CHECK(cell(lost, "Walk", "Catch") == R"(unreachable: Catch is not made to run.
)");
  CHECK(cell(lost, "Catch", "Walk") == R"(unreachable: Catch is not made to run.
)");
  CHECK(cell(lost, "Throw", "Catch") == R"(unreachable: Catch is not made to run.
)");
}

TEST_CASE("states that only bodies set may have assumed values at the beginning of a row, and the row lists them") {
  const char* const boxes = R"(states: {Load: {values: [none, box], initial: none, of: Carry}}
roots: {Carry: {priority: 1}, Rest: {priority: 2}}
groups:
  Carry:
    providers:
      - {name: putting_down, when: [Load == box], tasks: [PutDown]}
      - {name: picking, sets: [Load == box], tasks: [Arm]}
  PutDown: {needs: [Arm]}
  Rest: {needs: [Arm]}
  Arm: {}
)";
  CHECK(cell(boxes, "PutDown", "Rest") == R"(hard: Rest takes at once what PutDown holds. PutDown stops.
stops PutDown
scenario: from PutDown to Rest
behaviour: test.yaml
script:
  Carry.putting_down:
    - {reason: subtask_done, done: true}
    - {tasks: [PutDown]}
  PutDown.default:
    - {reason: wait, done: true}
    - {wait: 1 ms}
given: {Load: box}
steps:
  - request: Carry
  - request: Rest
)");
}

TEST_CASE("states from outside: the first declared value that does, and no more of them than are needed") {
  const char* const senses = R"(states:
  Ball: {values: [lost, far, near], initial: lost, external: true}
  Game: {values: [off, on], external: true}
roots: {Play: {priority: 1}, Kick: {priority: 2}}
groups:
  Play: {when: [Ball != lost, Game == on], needs: [Legs]}
  Kick: {when: [Ball == near, Game == on], needs: [Legs]}
  Legs: {}
)";
  CHECK(cell(senses, "Play", "Kick") ==
        R"(hard: Kick takes at once what Play holds. Play stops. From outside: Ball == near.
stops Play
scenario: from Play to Kick
behaviour: test.yaml
script:
  Play.default:
    - {reason: wait, done: true}
    - {wait: 1 ms}
steps:
  - inputs: [{set: {Ball: far, Game: "on"}}, {request: Play}]
  - inputs: [{set: {Ball: near}}, {request: Kick}]
)");
}

} // namespace director::tests
