// SPDX-License-Identifier: MIT
// Small behaviours, each named for the kind of its cell; the whole cell is compared, and its scenario.
#include "compiler/lower/lower.hpp"
#include "compiler/transitions/matrix.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace director::tests {

namespace {

using compiler::GroupId;
using compiler::Transition;
using compiler::TransitionMatrix;

std::string names(const compiler::Model& model, const std::vector<GroupId>& groups) {
  std::string out;
  for (const GroupId id : groups) out += " " + model.groups[id].name.value;
  return out;
}

/// Its kind and words, what stops and what is taken, then its scenario.
std::string cell(const std::string& behaviour, const std::string& from, const std::string& to) {
  const Compiled compiled = compile("behaviour: test\nlanguage: 1\n" + behaviour);
  const compiler::Model& model = compiled.model;
  const TransitionMatrix matrix = compiler::find_transitions(model, compiler::lower(model), "test.yaml");
  const auto at = [&](const std::string& name) {
    return static_cast<std::size_t>(
        std::find_if(matrix.rows.begin(), matrix.rows.end(),
                     [&](const TransitionMatrix::Row& row) { return model.groups[row.group].name.value == name; }) -
        matrix.rows.begin());
  };
  REQUIRE(at(from) < matrix.rows.size());
  REQUIRE(at(to) < matrix.rows.size());
  const Transition& found = matrix.rows[at(from)].cells[at(to)];
  std::string out = fmt::format("{}: {}\n", name_of(found.kind), found.words);
  for (const Transition::Push& push : found.pushes)
    out += fmt::format("push {} for {} within {}\n", model.full_name(push.to), push.condition,
                       push.within ? std::to_string(*push.within) : "-");
  if (found.bound) out += fmt::format("bound {}\n", *found.bound);
  if (!found.stops.empty()) out += "stops" + names(model, found.stops) + "\n";
  if (!found.taken.empty()) out += "taken" + names(model, found.taken) + "\n";
  for (const std::size_t piece : found.scenario) out += matrix.pieces[piece];
  return out;
}

/// Its kind and words.
std::string words(const std::string& behaviour, const std::string& from, const std::string& to) {
  const std::string all = cell(behaviour, from, to);
  return all.substr(0, all.find('\n'));
}

/// How the group is brought to run.
std::string row(const std::string& behaviour, const std::string& group) {
  const Compiled compiled = compile("behaviour: test\nlanguage: 1\n" + behaviour);
  const compiler::Model& model = compiled.model;
  const TransitionMatrix matrix = compiler::find_transitions(model, compiler::lower(model), "test.yaml");
  for (const TransitionMatrix::Row& each : matrix.rows) {
    if (model.groups[each.group].name.value == group) return each.words;
  }
  return {};
}

const char* const legs = R"(states: {Pose: {values: [moving, still], initial: still}}
roots: {Kick: {priority: 20}, Walk: {priority: 10}, Look: {}}
groups:
  Kick: {when: [Pose == still], needs: [Legs]}
  Walk:
    providers:
      - {name: walking, needs: [Legs], sets: [Pose == moving], tasks: [Legs]}
      - {name: halting, needs: [Legs], causing: [Pose == still within 2 s], tasks: [Legs]}
  Look: {needs: [Head]}
  Legs: {}
  Head: {}
)";

const char* const plans = R"(roots: [Play, Sleep]
groups:
  Play:
    packs:
      shoot: {Kick: {}}
      run: {Walk: {}}
  Kick: {needs: [Legs]}
  Walk: {needs: [Legs]}
  Sleep: {needs: [Legs]}
  Legs: {}
)";

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

TEST_CASE("soft: the second waits, the first is pushed, and what promises the state is named with its time") {
  CHECK(
      cell(legs, "Walk", "Kick") ==
      R"(soft: Kick waits. Walk is pushed to halting for Pose == still, within 2 s. Then Kick takes over. Walk and Legs stop.
push Walk.halting for Pose == still within 2000000
bound 2000000
stops Walk Legs
scenario: from Walk to Kick
behaviour: test.yaml
script:
  Walk.walking:
    - {reason: wait, done: true}
    - {set: {Pose: moving}, tasks: [Legs], wait: 1 ms}
  Walk.halting:
    - {reason: wait, done: true}
    - {reason: pushed, set: {Pose: still}, tasks: [Legs], wait: 1 ms}
    - {tasks: [Legs], wait: 1 ms}
steps:
  - request: Walk
  - request: Kick
)");
}

TEST_CASE("soft: the first may set several values, and sets one that contradicts what its group promises") {
  const auto kick = [](const std::string& sets) {
    return words(fmt::format(R"(states: {{Pose: {{values: [still, slow, fast], initial: still}}}}
roots: {{Kick: {{priority: 20}}, Walk: {{priority: 10}}}}
groups:
  Kick: {{when: [Pose == still], needs: [Legs]}}
  Walk:
    providers:
      - {{name: walking, needs: [Legs], sets: [{}], tasks: [Legs]}}
      - {{name: halting, needs: [Legs], causing: [Pose == still within 2 s], tasks: [Legs]}}
  Legs: {{}}
)",
                             sets),
                 "Walk", "Kick");
  };
  const std::string soft =
      "soft: Kick waits. Walk is pushed to halting for Pose == still, within 2 s. Then Kick takes over. Walk and Legs "
      "stop.";
  CHECK(kick("Pose == fast") == soft);
  CHECK(kick("Pose == slow|fast") == soft);
  CHECK(kick("Pose != still") == soft);
  CHECK(kick("Pose") == soft);
  CHECK(kick("Pose == still|fast") == soft);
  CHECK(kick("Pose == still") == "hard: Kick takes at once what Walk holds. Walk and Legs stop.");
}

TEST_CASE("of several values a body sets the first that suits it and that no other provider of its group promises") {
  const auto set = [](const std::string& walking, const std::string& others = "") {
    const std::string all =
        cell(fmt::format(R"(states: {{Pose: {{values: [still, slow, fast, sitting], initial: still}}}}
roots: {{Kick: {{priority: 20}}, Walk: {{priority: 10}}}}
groups:
  Kick: {{when: [Pose == still], needs: [Legs]}}
  Walk:
    providers:
      - {{name: walking, needs: [Legs], tasks: [Legs], {}}}
      - {{name: halting, needs: [Legs], causing: [Pose == still within 2 s], tasks: [Legs]}}
{}  Legs: {{}}
)",
                         walking, others),
             "Walk", "Kick");
    const std::string begin = "  Walk.walking:\n    - {reason: wait, done: true}\n    - {";
    const std::size_t at = all.find(begin) + begin.size();
    return all.substr(at, all.find("tasks:", at) - at);
  };
  CHECK(set("sets: [Pose]") == "set: {Pose: slow}, ");
  CHECK(set("sets: [Pose == fast|sitting]") == "set: {Pose: fast}, ");
  CHECK(set("sets: [Pose]", "      - {name: creeping, needs: [Legs], causing: [Pose == slow], tasks: [Legs]}\n") ==
        "set: {Pose: fast}, ");
  CHECK(set("sets: [Pose == still|slow]",
            "      - {name: creeping, needs: [Legs], causing: [Pose == slow], tasks: [Legs]}\n") ==
        "set: {Pose: still}, ");
  CHECK(set("sets: [Pose], when: [Pose != slow]") == "set: {Pose: fast}, ");
  CHECK(set("sets: [Pose], when: [Pose == still]").empty());
}

TEST_CASE("both: it does not depend on a value that a body need not set that the second runs") {
  const auto camera = [](const std::string& sets) {
    return words(fmt::format(R"(states: {{Pose: {{values: [still, slow, fast], initial: still}}}}
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

TEST_CASE("soft: of all that one push is to cause the longest time counts") {
  const auto kick = [](const std::string& promises) {
    const std::string all = cell(fmt::format(R"(states:
  Pose: {{values: [moving, still], initial: still}}
  Arm: {{values: [up, down], initial: up}}
  Eye: {{values: [open, shut], initial: shut}}
roots: {{Kick: {{priority: 20}}, Walk: {{priority: 10}}}}
groups:
  Kick: {{when: [Pose == still, Arm == down], needs: [Legs]}}
  Walk:
    providers:
      - {{name: walking, needs: [Legs], sets: [Pose == moving], tasks: [Legs]}}
      - {{name: halting, needs: [Legs], causing: [{}, Eye == open within 1 min], tasks: [Legs]}}
  Legs: {{}}
)",
                                             promises),
                                 "Walk", "Kick");
    return all.substr(0, all.find("stops"));
  };
  CHECK(kick("Pose == still within 1 s, Arm == down within 10 s") ==
        "soft: Kick waits. Walk is pushed to halting for Pose == still, within 1 s, and for Arm == down, within 10 s. "
        "All of that is promised within 10 s. Then Kick takes over. Walk and Legs stop.\n"
        "push Walk.halting for Pose == still within 1000000\n"
        "push Walk.halting for Arm == down within 10000000\n"
        "bound 10000000\n");
  CHECK(kick("Pose == still within 1 s, Arm == down") ==
        "soft: Kick waits. Walk is pushed to halting for Pose == still, within 1 s, and for Arm == down. No time is "
        "promised for all of that. Then Kick takes over. Walk and Legs stop.\n"
        "push Walk.halting for Pose == still within 1000000\n"
        "push Walk.halting for Arm == down within -\n");
}

TEST_CASE("soft: what is waited for on the way to what takes over counts, and what only runs afterwards does not") {
  const char* const chain = R"(states:
  Pose: {values: [moving, still], initial: still}
  Arm: {values: [up, down], initial: up}
  Eye: {values: [open, shut], initial: shut}
roots: {Strike: {priority: 20}, Walk: {priority: 10}}
groups:
  Strike: {when: [Pose == still], tasks: [Kick]}
  Kick: {when: [Arm == down], needs: [Legs], tasks: [Look]}
  Look: {when: [Eye == open], needs: [Head]}
  Walk:
    providers:
      - {name: walking, needs: [Legs], sets: [Pose == moving], tasks: [Legs]}
      - name: halting
        needs: [Legs]
        causing: [Pose == still within 1 s, Arm == down within 10 s, Eye == open within 20 s]
        tasks: [Legs]
  Legs: {}
  Head: {}
)";
  const std::string pushed =
      " waits. Walk is pushed to halting for Pose == still, within 1 s, and for Arm == down, within 10 s";
  CHECK(words(chain, "Walk", "Strike") ==
        "soft: Strike" + pushed + ". All of that is promised within 10 s. Then Strike takes over. Walk and Legs stop.");
  CHECK(words(chain, "Walk", "Kick") ==
        "soft: Kick" + pushed + ". All of that is promised within 10 s. Then Kick takes over. Walk and Legs stop.");
  CHECK(words(chain, "Walk", "Look") == "soft: Look" + pushed +
                                            ", and for Eye == open, within 20 s. All of that is promised within 20 s. "
                                            "Then Look takes over. Walk and Legs stop.");
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
  CHECK(row(trip, "Work") == "Requested by way of Trip \u2192 Work.");
  CHECK(words(trip, "Guard", "Work") == "both: Guard and Work run beside each other.");
}

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

TEST_CASE("hard: what leads to the first one stops too, and is named where only it held what is taken") {
  const char* const above = R"(roots: {Guard: {priority: 10}, Plan: {priority: 1}}
groups:
  Guard: {needs: [Arm], tasks: [Arm]}
  Plan: {stop: true, needs: [Arm], tasks: [Arm, Think]}
  Think: {tasks: [Note]}
  Note: {}
  Arm: {}
)";
  CHECK(words(above, "Think", "Guard") ==
        "hard: Guard takes at once what Plan, which leads to Think, holds. Plan, Think and Note stop.");
  const char* const below = R"(roots: {Guard: {priority: 10}, Plan: {priority: 1}}
groups:
  Guard: {needs: [Arm, Leg], tasks: [Arm]}
  Plan: {needs: [Leg], tasks: [Grip]}
  Grip: {needs: [Arm], tasks: [Arm]}
  Arm: {}
  Leg: {}
)";
  CHECK(words(below, "Grip", "Guard") ==
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
  CHECK(words(held, "Wheel", "Boss") == "hard: Boss takes at once what Wheel holds. Old and Wheel stop.");
  CHECK(words(held, "Wheel", "Aim") == "hard: Aim takes at once what Wheel holds. Old and Wheel stop.");
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
  CHECK(words(R"(roots: [Carry, Move]
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
  const auto words = [&](const std::string& from, const std::string& to) {
    const std::string all = cell(behaviour, from, to);
    return all.substr(0, all.find('\n'));
  };
  CHECK(words("Walk", "Kick") ==
        "replaced: Play requests Attack, which leads to Kick, instead of Defend, which leads to "
        "Walk. Defend and Walk stop.");
  CHECK(words("Defend", "Kick") ==
        "replaced: Play requests Attack, which leads to Kick, instead of Defend. Defend and Walk stop.");
  CHECK(words("Walk", "Attack") ==
        "replaced: Play requests Attack instead of Defend, which leads to Walk. Defend and Walk stop.");
}

TEST_CASE("condition lost: the first one runs on without what it loses, or for another requester") {
  const std::string person = "states: {Person: {values: [near, none], initial: near, external: true}}\n";
  CHECK(words(person + R"(roots: {Safety: {priority: 20}, Drive: {priority: 10}}
groups:
  Safety:
    providers:
      - {name: stopping, when: [Person == near], tasks: [Freeze]}
      - {name: watching}
  Freeze: {needs: [Wheels], tasks: [Wheels]}
  Drive: {when: [Person == none], needs: [Wheels], tasks: [Wheels]}
  Wheels: {}
)",
              "Safety", "Drive") == "condition lost: What Drive wants from outside ends groups below Safety, which "
                                    "runs on. Freeze stops. Wheels runs "
                                    "on, but not for Safety any more. The outside says Person == none.");
  CHECK(words(person + R"(roots: [Stay, Go]
groups:
  Stay: {when: [Person == near], tasks: [Walk]}
  Go: {when: [Person == none], tasks: [Walk]}
  Walk: {needs: [Legs]}
  Legs: {}
)",
              "Walk", "Go") ==
        "condition lost: By what Go wants from outside, Stay stops. Walk runs on, but not for Stay any more. "
        "The outside says Person == none.");
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
        R"(condition lost: What Play wants from outside ends Wait. The outside says Phase == playing.
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

TEST_CASE("soft: the second requests what the first one ran for, and that is pushed for this request") {
  const auto boss = [](const std::string& order) {
    return words(fmt::format(R"(states: {{Door: {{values: [shut, open], initial: shut}}}}
roots: {{Boss: {{priority: 2}}, Crew: {{priority: 1}}}}
groups:
  Boss: {{packs: {{go: {{{}}}}}}}
  Enter: {{when: [Door == open]}}
  Crew: {{tasks: [Hand]}}
  Hand: {{providers: [{{name: idle, when: [Door == open]}}, {{name: push, causing: [Door == open within 5 s]}}]}}
)",
                             order),
                 "Crew", "Boss");
  };
  const std::string soft =
      "soft: Boss waits. Hand is pushed to push for Door == open, within 5 s. Then Boss takes over. "
      "Hand runs on, but not for Crew any more.";
  CHECK(boss("Enter: {}, Hand: {}") == soft);
  CHECK(boss("Hand: {}, Enter: {}") == soft);
}

TEST_CASE("soft: the values let the requester request both, and the second one pushes the first one") {
  const auto keeper = [](const std::string& clearing) {
    return R"(states:
  Ball: {values: [far, near], initial: far, external: true}
  Posture: {values: [standing, walking], initial: standing}
roots: [Keep]
groups:
  Keep:
    providers:
      - {name: clearing, when: [Ball == near], )" +
           clearing + R"(}
      - {name: placing, tasks: [Walk]}
  Clear: {when: [Posture == standing], needs: [Legs], tasks: [Legs]}
  Walk:
    providers:
      - {name: walking, needs: [Legs], sets: [Posture == walking], tasks: [Legs]}
      - {name: halting, needs: [Legs], causing: [Posture == standing], tasks: [Legs]}
  Legs: {}
)";
  };
  const char* const soft =
      "soft: Clear waits. Walk is pushed to halting for Posture == standing. No time is promised for that. Then Clear "
      "takes over. Walk stops. Legs runs on, but not for Walk any more. The outside says Ball == near.";
  CHECK(words(keeper("packs: {go: {Clear: {priority: 20}, Walk: {apart: true}}}"), "Walk", "Clear") == soft);
  CHECK(words(keeper("packs: {idle: {}, go: {Clear: {priority: 20}, Walk: {apart: true}}}"), "Walk", "Clear") == soft);
}

TEST_CASE("soft: what the first one runs for is requested with the second one too, and runs on") {
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
    CHECK(
        words(text, first, "Kick") ==
        "soft: Kick waits. Walk is pushed to halting for Stability == standing, within 2 s. Then Game, which leads to "
        "Kick, takes over. LookAt and Head run on, but not for Gaze any more.");
  }
}

TEST_CASE("hard: the values let the requester request both, and the second one takes what is below the first one") {
  CHECK(words(R"(states: {Ball: {values: [far, near], initial: far, external: true}}
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
              "Clear") == "hard: Clear takes at once what Place holds. Walk stops. The outside says Ball == near.");
}

TEST_CASE("condition lost: the second one takes what is below the first one, which the outside has ended") {
  CHECK(words(R"(states: {Ball: {values: [far, near], initial: far, external: true}}
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
        "not for Walk any more. The outside says Ball == near.");
}

TEST_CASE(
    "hard: the requester has another provider for the second one, but goes on requesting both in that of the first") {
  CHECK(words(R"(states:
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
              "Walk", "Clear") == "hard: Clear takes at once what Walk holds. Walk stops. Legs runs on, but not for "
                                  "Walk any more. The outside says Ball == near.");
}

TEST_CASE("replaced: the provider that the outside brings about may go on requesting the first one") {
  for (const char* const packs : {"hold: {Walk: {}}, clear: {Clear: {}}", "clear: {Clear: {}}, hold: {Walk: {}}"}) {
    CHECK(words(R"(states: {Ball: {values: [far, near], initial: far, external: true}}
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
                "Walk", "Clear") == "replaced: Keep requests Clear instead of Walk. Walk stops. Legs runs on, but not "
                                    "for Walk any more. The outside says Ball == near.");
  }
}

TEST_CASE("condition lost: a body of the second one sets what ends the first one, of which nothing is taken") {
  const auto walk = [](const std::string& sets, const std::string& guard = "Eye") {
    return words(fmt::format(R"(states: {{Mode: {{values: [day, dusk, night], initial: day}}}}
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
  CHECK(words(R"(states: {Stability: {values: [fallen, moving, standing], initial: standing, external: true}}
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
              "Kick", "GetUp") == "condition lost: What GetUp wants from outside ends Kick. Kick stops. Legs runs on, "
                                  "but not for Kick any more. The outside says Stability == fallen.");
}

TEST_CASE("condition lost: the outside ends the provider that is preferred to the one that leads to the second one") {
  for (const char* const initial : {"away", "near"}) {
    CHECK(words("states: {Penalty: {values: [away, near], initial: " + std::string(initial) + R"(, external: true}}
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
                "Dive", "Walk") == "condition lost: What Walk wants from outside ends Dive. Dive stops. Legs runs on, "
                                   "but not for Dive any more. The outside says Penalty == away.");
  }
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
  CHECK(words(down, "TakeOff", "Land") ==
        "hard: Fly, which is requested with Land, takes at once what TakeOff holds. TakeOff stops. Rotors runs on, but "
        "not for TakeOff any more.");
  CHECK(words(down, "TakeOff", "Safety") ==
        "hard: Safety takes at once what TakeOff holds. TakeOff stops. Rotors runs on, but not for TakeOff any more.");
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
           " stops. Legs runs on, but not for " + group + " any more. The outside says " + state + ".";
  };
  // A value that prevents one of them lets the other one run.
  const std::string modes = keeper("{Mode: {values: [a, b, c], initial: c, external: true}}", "Mode == b", "Mode == a");
  CHECK(words(modes, "Dive", "Walk") == lost("Dive", "Mode == c"));
  CHECK(words(modes, "Kick", "Walk") == lost("Kick", "Mode == c"));
  // Not both conditions of the first one can be made false with one of the second one.
  const std::string range = keeper("{Battery: {range: [0, 100], initial: 100, external: true}}",
                                   "Battery >= 20, Battery < 50", "Battery < 20");
  CHECK(words(range, "Dive", "Walk") == lost("Dive", "Battery == 50"));
  CHECK(words(range, "Kick", "Walk") == lost("Kick", "Battery == 50"));
}

TEST_CASE("never: nothing causes what it waits for, also when the first one is done") {
  const char* const lost = R"(states: {Pose: {values: [moving, still]}}
roots: [Walk, Wait]
groups:
  Walk: {needs: [Legs]}
  Wait: {when: [Pose == still], needs: [Head]}
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
  CHECK(words(climbing, "Rest", "Climb") == "hard: Climb takes at once what Rest holds. Rest stops. Move runs on, but "
                                            "not for Rest any more. The outside says Ground == rough.");
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
  CHECK(words(delivery, "Rest", "Drive") == "hard: Drive takes at once what Rest holds. Rest stops. Wheels runs on, "
                                            "but not for Rest any more. The outside says Door == open.");
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

TEST_CASE("what ran for the first one runs for another requester, and so does what the first one requested") {
  const std::string patrol = R"(roots: {Patrol: {priority: 20}, Report: {priority: 10}}
groups:
  Patrol: {packs: {go: {Look: {priority: 5, optional: true})";
  const std::string rest = R"(}}}
  Look: {tasks: {Head: {optional: true}}}
  Report: {tasks: [Look]}
  Head: {}
)";
  CHECK(words(patrol + rest, "Look", "Report") ==
        "hard: Report takes at once what Look holds. Look and Head run on, but not for Patrol any more.");
  CHECK(words(patrol + ", Head: {optional: true}" + rest, "Look", "Report") ==
        "hard: Report takes at once what Look holds. Look runs on, but not for Patrol any more. Head runs on, but not "
        "for Look any more.");
}

TEST_CASE("what takes over is named where it is above the second, which itself takes nothing") {
  CHECK(words(R"(roots: {KickTo: {priority: 20}, Look: {priority: 10}}
groups:
  KickTo: {packs: {go: {Kick: {}, LookAt: {}}}}
  Look: {tasks: [LookAt]}
  LookAt: {}
  Kick: {needs: [Legs]}
  Legs: {}
)",
              "Look", "Kick") == "hard: KickTo, which leads to Kick, takes at once what Look holds. LookAt runs on, "
                                 "but not for Look any more.");
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
        R"(condition lost: What Brace wants from outside ends Kick. The outside says Pose == falling.
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
  CHECK(words(R"(states:
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
        R"(hard: Kick takes at once what Play holds. Play stops. The outside says Ball == near.
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
