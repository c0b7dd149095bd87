// SPDX-License-Identifier: MIT
// Small behaviours, each named for the kind of its cell; the whole cell is compared, and its scenario. The kinds
// soft, hard and condition lost: soft_test.cpp, hard_test.cpp, lost_test.cpp.
#include "tests/compiler/transitions/cell.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace director::tests {

TEST_CASE("both: it does not depend on a value that a body need not set that the second runs") {
  const auto camera = [](const std::string& sets) {
    return cell_words(fmt::format(R"(states: {{Pose: {{values: [still, slow, fast], initial: still}}}}
roots: [Play, Film]
groups:
  Play: {{packs: {{go: {{Walk: {{priority: 10}}}}}}}}
  Film: {{when: [Pose == still], needs: [Eye]}}
  Eye: {{}}
  Walk:
    providers:
      - {{name: walking, needs: [Legs], sets: [{}], tasks: [Legs]}}
      - {{name: halting, needs: [Legs], causing: [Pose == still within 2 s], tasks: [Legs]}}
  Legs: {{}}
)",
                                  sets),
                      "Walk", "Film");
  };
  CHECK(camera("Pose == slow|still") == "both: Walk and Film run beside each other.");
  CHECK(camera("Pose == slow").starts_with("never: Film does not run, nor when Walk is done."));
}

TEST_CASE("row: a task that does not run in the first pack that leads there is tried in the others") {
  const std::string cook = R"(roots: {Cook: {priority: 1}, Clean: {priority: 2}}
groups:
  Cook:
    packs:
      both: {Left: {priority: 2, apart: true}, Right: {priority: 1, apart: true}}
      right: {Right: {}}
  Left: {needs: [Belt]}
  Right: {needs: [Belt]}
  Clean: {needs: [Belt]}
  Belt: {}
)";
  CHECK(row_words(cook, "Right") == "Requested by way of Cook \u2192 Right.");
  CHECK(cell_words(cook, "Right", "Clean") == "hard: Clean takes at once what Right holds. Right stops.");
}

TEST_CASE("row: what lets a provider run that promises what it waits for is set from outside") {
  const std::string boat = R"(states:
  Wind: {values: [strong, calm], initial: strong, external: true}
  Sail: {values: [furled, full], initial: furled}
roots: {SailTo: {priority: 10}, Fish: {priority: 5}}
groups:
  SailTo: {packs: {go: {Cruise: {priority: 2}, Rig: {apart: true}}}}
  Cruise: {when: [Sail == full], needs: [Rudder]}
  Fish: {needs: [Rudder]}
  Rig:
    providers:
      - {name: keeping, sets: [Sail == furled]}
      - {name: setting, when: [Wind == calm], causing: [Sail == full within 9 s]}
  Rudder: {}
)";
  CHECK(row_words(boat, "Cruise") == "Requested by way of SailTo \u2192 Cruise. From outside: Wind == calm.");
  CHECK(
      cell_words(boat, "Fish", "Cruise") ==
      "soft: Cruise waits. Rig is pushed to setting for Sail == full, within 9 s. Then Cruise takes over. Fish stops. "
      "From outside: Wind == calm.");
}

TEST_CASE("waits: the requester of the second runs in another way meanwhile, and is named") {
  CHECK(
      cell(R"(roots: {Guard: {priority: 20}, Serve: {priority: 10}}
groups:
  Guard: {needs: [Legs]}
  Serve:
    providers:
      - {name: going, needs: [Legs], tasks: [Walk]}
      - {name: resting}
  Walk: {tasks: [Head]}
  Legs: {}
  Head: {}
)",
           "Guard", "Walk") ==
      R"(waits: Walk is not requested yet, and runs when Guard is done. Serve runs in resting and does not request Walk.
scenario: from Guard to Walk
behaviour: test.yaml
script:
  Guard.default:
    - {reason: wait, done: true}
    - {wait: 1 ms}
  Serve.going:
    - {tasks: [Walk]}
steps:
  - request: Guard
  - request: Serve
  - advance: 1 ms
)");
}

TEST_CASE("waits: what leads to the second one waits, as the first one has the same task already") {
  CHECK(cell_words(R"(roots: [Carry, Move]
groups:
  Carry: {packs: {go: {Move: {}}}}
  Move: {packs: {rest: {}, look: {Look: {}}}}
  Look: {tasks: [Eye]}
  Eye: {}
)",
                   "Carry", "Look") ==
        "waits: Look is not requested yet, and runs when Carry is done. Move waits (root>Move): Move is held by "
        "Carry>Move, and root>Carry is the equal of root>Move (priority 0) and was there first.");
}

TEST_CASE("waits: the weaker one is queued, and runs when the stronger one is done") {
  CHECK(
      cell(legs, "Kick", "Walk") ==
      R"(waits: Walk is queued, and runs when Kick is done. Walk waits (root>Walk): Legs, which it needs, is held by Kick>Legs, and root>Kick (priority 20) goes before root>Walk (priority 10).
scenario: from Kick to Walk
behaviour: test.yaml
script:
  Kick.default:
    - {reason: wait, done: true}
    - {wait: 1 ms}
  Walk.walking:
    - {set: {Pose: moving}, tasks: [Legs]}
steps:
  - request: Kick
  - request: Walk
  - advance: 1 ms
)");
}

TEST_CASE("both: they share nothing") {
  CHECK(cell(legs, "Look", "Kick") == R"(both: Look and Kick run beside each other.
scenario: from Look to Kick
behaviour: test.yaml
script:
  Look.default:
    - {reason: wait, done: true}
    - {wait: 1 ms}
steps:
  - request: Look
  - request: Kick
)");
}

TEST_CASE("same chain: the requester leads to its task, whichever of them is first") {
  CHECK(cell(plans, "Play", "Kick") == R"(same chain: One of Play and Kick leads to the other.
)");
  CHECK(cell(plans, "Kick", "Play") == R"(same chain: One of Kick and Play leads to the other.
)");
  CHECK(cell(plans, "Kick", "Kick") == R"(same chain: It is the same group.
)");
}

TEST_CASE("replaced: the requester of both has no pack that contains both") {
  CHECK(cell(plans, "Walk", "Kick") == R"(replaced: Play requests Kick instead of Walk. Walk stops.
stops Walk
scenario: from Walk to Kick
behaviour: test.yaml
script:
  Play.default:
    - {run: 1, pack: run}
    - {pack: shoot}
  Walk.default:
    - {reason: wait, done: true}
    - {wait: 1 ms}
steps:
  - request: Play
  - request: Play
)");
}

TEST_CASE("replaced: the tasks are named between which the requester changes, and where they lead") {
  const std::string behaviour = R"(roots: [Play]
groups:
  Play: {packs: {attack: {Attack: {}}, defend: {Defend: {}}}}
  Attack: {tasks: [Kick]}
  Defend: {tasks: [Walk]}
  Kick: {needs: [Legs]}
  Walk: {needs: [Legs]}
  Legs: {}
)";
  const auto words = [&](const std::string& from, const std::string& to) { return cell_words(behaviour, from, to); };
  CHECK(words("Walk", "Kick") ==
        "replaced: Play requests Attack, which leads to Kick, instead of Defend, which leads to "
        "Walk. Defend and Walk stop.");
  CHECK(words("Defend", "Kick") ==
        "replaced: Play requests Attack, which leads to Kick, instead of Defend. Defend and Walk stop.");
  CHECK(words("Walk", "Attack") ==
        "replaced: Play requests Attack instead of Defend, which leads to Walk. Defend and Walk stop.");
}

TEST_CASE("replaced: the provider that the outside brings about may go on requesting the first one") {
  for (const char* const packs : {"hold: {Walk: {}}, clear: {Clear: {}}", "clear: {Clear: {}}, hold: {Walk: {}}"}) {
    CHECK(cell_words(R"(states: {Ball: {values: [far, near], initial: far, external: true}}
roots: [Keep]
groups:
  Keep:
    providers:
      - {name: placing, when: [Ball == far], tasks: [Walk]}
      - {name: near, when: [Ball == near], packs: {)" +
                         std::string(packs) + R"(}}
  Clear: {needs: [Legs], tasks: [Legs]}
  Walk: {needs: [Legs], tasks: [Legs]}
  Legs: {}
)",
                     "Walk", "Clear") ==
          "replaced: Keep requests Clear instead of Walk. Walk stops. Legs runs on, but not "
          "for Walk any more. From outside: Ball == near.");
  }
}

TEST_CASE("never: nothing causes what it waits for, also when the first one is done") {
  const char* const lost = R"(states: {Pose: {values: [moving, still]}}
roots: [Walk, Wait, Stand]
groups:
  Walk: {needs: [Legs]}
  Wait: {when: [Pose == still], needs: [Head]}
  Stand: {needs: [Legs], sets: [Pose == still]}
  Legs: {}
  Head: {}
)";
  CHECK(
      cell(lost, "Walk", "Wait") ==
      R"(never: Wait does not run, nor when Walk is done. Wait waits (root>Wait): until Pose == still, which no enabled provider promises.
scenario: from Walk to Wait
behaviour: test.yaml
script:
  Walk.default:
    - {reason: wait, done: true}
    - {wait: 1 ms}
steps:
  - request: Walk
  - request: Wait
  - advance: 1 ms
)");
}

TEST_CASE("endless: the groups are named that run in turn") {
  const std::string lamp = "states: {Lamp: {values: [off, on], initial: on, external: true}}\n";
  const std::string groups = R"(groups:
  Light: {tasks: {Up: {apart: true}, Down: {apart: true}}}
  Up: {causing: [Lamp == on]}
  Down: {causing: [Lamp == off]}
)";
  CHECK(cell(lamp + "roots: {Film: {priority: 20}, Light: {priority: 10}}\n" + groups + R"(
  Film: {when: [Lamp == on], tasks: [Charge]}
  Charge: {when: [Lamp == off]}
)",
             "Film", "Light") ==
        R"(endless: When Light is requested, the engine does not come to rest: Up, Down and Film run again and again.
scenario: from Film to Light
behaviour: test.yaml
script:
  Up.default:
    - {reason: pushed, set: {Lamp: "on"}}
    - {}
  Down.default:
    - {reason: pushed, set: {Lamp: "off"}}
    - {}
  Film.default:
    - {reason: wait, done: true}
    - {tasks: [Charge], wait: 1 ms}
steps:
  - request: Film
  - request: Light
)");
}

TEST_CASE("both: as few values from outside as possible let the second one run") {
  CHECK(cell_words(R"(states:
  Light: {values: [off, on], initial: off, external: true}
  Door: {values: [shut, open], initial: shut, external: true}
  Fan: {values: [off, on], initial: off, external: true}
roots: [Walk, Greet]
groups:
  Walk: {needs: [Legs]}
  Greet:
    providers:
      - {name: host, when: [Light == on, Door == open, Fan == on], needs: [Voice]}
      - {name: usher, when: [Light == on, Door == open], needs: [Voice]}
      - {name: clerk, when: [Fan == on], needs: [Voice]}
  Legs: {}
  Voice: {}
)",
                   "Walk", "Greet") == "both: Walk and Greet run beside each other. From outside: Fan == on.");
}

TEST_CASE(
    "both: the requester goes on in the pack of the first one, if that requests both, and not in an earlier one") {
  const std::string all = cell(R"(states: {Water: {values: [cold, hot], initial: cold}}
roots: [Serve]
groups:
  Serve:
    packs:
      coffee: {Brew: {priority: 2}, Boiler: {priority: 1}}
      tea: {Brew: {priority: 2, apart: true}, Boiler: {priority: 1}}
  Brew: {when: [Water == hot], needs: [Mains]}
  Boiler:
    providers:
      - {name: saving, needs: [Mains]}
      - {name: heating, causing: [Water == hot]}
  Mains: {}
)",
                               "Brew", "Boiler");
  CHECK(all.starts_with("both: Brew and Boiler run beside each other."));
  CHECK(all.find(R"(
  Serve.default:
    - {run: 1, pack: tea}
    - {reason: subtask_done, continue: true}
    - {pack: tea, with: [Brew: {keep: true}]}
)") != std::string::npos);
}

TEST_CASE("never: what is pushed is told before what stops by that") {
  CHECK(cell_words(R"(states:
  Arm: {values: [out, in], initial: out}
  Door: {values: [open, shut], initial: open}
roots: {Drive: {priority: 100}, Load: {}}
groups:
  Drive: {when: [Arm == in, Door == shut], tasks: [Wheels]}
  Load:
    providers:
      - {name: lifting, packs: {lift: {Watch: {}}}}
      - {name: folding, causing: [Arm == in]}
  Watch: {causing: [Door == shut]}
  Wheels: {}
)",
                   "Load", "Drive") ==
        "never: Load is pushed to folding for Arm == in. Watch is pushed to default for Door == shut. Watch stops. "
        "Drive does not run, nor when Load is done. Drive waits (root>Drive): until Door == shut, which Watch could "
        "cause.");
}

TEST_CASE("never: a push that is made again is told once") {
  CHECK(cell_words(R"(states:
  Gimbal: {values: [loose, locked], initial: loose}
  Gps: {values: [poor, good], initial: poor, external: true}
roots: {Pilot: {priority: 50}, Mission: {}}
groups:
  Pilot: {packs: {steer: {Fly: {}}}}
  Mission: {packs: {shoot: {Fly: {priority: 5}, Point: {}}}}
  Fly: {when: [Gps == good], needs: [Rotors]}
  Point: {causing: [Gimbal == locked within 1 s]}
  Rotors: {when: [Gimbal == locked]}
)",
                   "Mission", "Fly") ==
        "never: Fly does not run, nor when Mission is done. Point is pushed to default for Gimbal == locked, within 1 "
        "s. From outside: Gps == good. Fly waits (Pilot>Fly): until Gimbal == locked, which Point could cause.");
}

TEST_CASE("what ran for the first one runs for another requester, and so does what the first one requested") {
  const std::string patrol = R"(roots: {Patrol: {priority: 20}, Report: {priority: 10}}
groups:
  Patrol: {packs: {go: {Look: {priority: 5, optional: true})";
  const std::string rest = R"(}}}
  Look: {tasks: {Head: {optional: true}}}
  Report: {tasks: [Look]}
  Head: {}
)";
  CHECK(cell_words(patrol + rest, "Look", "Report") ==
        "hard: Report takes at once what Look holds. Look and Head run on, but not for Patrol any more.");
  CHECK(cell_words(patrol + ", Head: {optional: true}" + rest, "Look", "Report") ==
        "hard: Report takes at once what Look holds. Look runs on, but not for Patrol any more. Head runs on, but not "
        "for Look any more.");
}

TEST_CASE("what takes over is named where it is above the second, which itself takes nothing") {
  CHECK(cell_words(R"(roots: {KickTo: {priority: 20}, Look: {priority: 10}}
groups:
  KickTo: {packs: {go: {Kick: {}, LookAt: {}}}}
  Look: {tasks: [LookAt]}
  LookAt: {}
  Kick: {needs: [Legs]}
  Legs: {}
)",
                   "Look", "Kick") ==
        "hard: KickTo, which leads to Kick, takes at once what Look holds. LookAt runs on, "
        "but not for Look any more.");
}

} // namespace director::tests
