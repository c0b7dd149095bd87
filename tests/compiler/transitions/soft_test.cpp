// SPDX-License-Identifier: MIT
// Cells where the second task waits until the first one, or what it holds, has been pushed.
#include "tests/compiler/transitions/cell.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace director::tests {

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
    return cell_words(fmt::format(R"(states: {{Pose: {{values: [still, slow, fast], initial: still}}}}
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

TEST_CASE("soft: a further condition that two promises of the pushed provider fulfil is told once") {
  CHECK(cell_words(R"(states:
  Pose: {values: [moving, slow, still], initial: moving}
  Arm: {values: [up, down], initial: up}
roots: {Kick: {priority: 20}, Walk: {priority: 10}}
groups:
  Kick: {when: [Arm == down, Pose != moving], needs: [Legs]}
  Walk:
    providers:
      - {name: walking, needs: [Legs], sets: [Pose == moving], tasks: [Legs]}
      - name: halting
        needs: [Legs]
        causing: [Arm == down within 3 s, Pose == slow|still within 1 s, Pose == still within 2 s]
        tasks: [Legs]
  Legs: {}
)",
                   "Walk", "Kick") ==
        "soft: Kick waits. Walk is pushed to halting for Arm == down, within 3 s, and for Pose != moving, within 1 s. "
        "All of that is promised within 3 s. Then Kick takes over. Walk and Legs stop.");
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
  CHECK(cell_words(chain, "Walk", "Strike") ==
        "soft: Strike" + pushed +
            ". All of that is promised within 10 s. Then Kick, which runs for Strike, takes over. Walk and Legs stop.");
  CHECK(cell_words(chain, "Walk", "Kick") ==
        "soft: Kick" + pushed + ". All of that is promised within 10 s. Then Kick takes over. Walk and Legs stop.");
  CHECK(cell_words(chain, "Walk", "Look") ==
        "soft: Look" + pushed +
            ", and for Eye == open, within 20 s. All of that is promised within 20 s. "
            "Then Look takes over. Walk and Legs stop.");
}

TEST_CASE("soft: the second requests what the first one ran for, and that is pushed for this request") {
  const auto boss = [](const std::string& order) {
    return cell_words(fmt::format(R"(states: {{Door: {{values: [shut, open], initial: shut}}}}
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
      "takes over. Walk stops. Legs runs on, but not for Walk any more. From outside: Ball == near.";
  CHECK(cell_words(keeper("packs: {go: {Clear: {priority: 20}, Walk: {apart: true}}}"), "Walk", "Clear") == soft);
  CHECK(cell_words(keeper("packs: {idle: {}, go: {Clear: {priority: 20}, Walk: {apart: true}}}"), "Walk", "Clear") ==
        soft);
}

TEST_CASE("soft: what the second wants from outside ends what requested the first, which runs on and is pushed") {
  CHECK(
      cell_words(R"(states:
  Dock: {values: [seen, touching], initial: seen, external: true}
  Gait: {values: [still, walking], initial: still}
roots: [Energy]
groups:
  Energy:
    providers:
      - {name: charging, when: [Dock == touching], packs: {go: {Charge: {priority: 5}, Walk: {apart: true}}}}
      - {name: hungry, tasks: [GoToDock]}
  GoToDock: {needs: [Walk], tasks: [Walk]}
  Charge: {when: [Gait == still], needs: [Legs]}
  Walk:
    providers:
      - {name: walking, needs: [Legs], sets: [Gait == walking], tasks: [Legs]}
      - {name: halting, needs: [Legs], causing: [Gait == still within 2 s], tasks: [Legs]}
  Legs: {}
)",
                 "Walk", "Charge") ==
      "soft: Charge waits. Walk is pushed to halting for Gait == still, within 2 s. Then Charge takes over. GoToDock, "
      "Walk and Legs stop. From outside: Dock == touching.");
}

} // namespace director::tests
