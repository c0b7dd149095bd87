// SPDX-License-Identifier: MIT
// Cells where something of the first task stops when the second is requested, although the first one runs at the end,
// or the second one does not.
#include "tests/compiler/transitions/cell.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace director::tests {

TEST_CASE("condition lost: what a body sets ends the first one, and a push for the first one lets it begin again") {
  for (const char* const stop : {"stop: true, ", ""}) {
    CHECK(cell(fmt::format(R"(states:
  Gate: {{values: [shut, open, locked], initial: open}}
  Night: {{values: [day, night], initial: day, external: true}}
roots: {{Work: {{priority: 20}}, Tune: {{priority: 10}}}}
groups:
  Work: {{{0}when: [Gate == open], needs: [Arm], tasks: [Arm]}}
  Tune:
    providers:
      - {{name: locking, when: [Night == night], causing: [Gate == locked]}}
      - {{name: airing, sets: [Gate == shut], causing: [Gate == open within 2 s], tasks: [Probe]}}
  Arm: {{}}
  Probe: {{}}
)",
                           stop),
               "Work", "Tune")
              .starts_with("condition lost: What Tune.airing sets (Gate == shut) ends Work. Work and Arm stop, and "
                           "begin again.\nagain Work Arm\nscenario:"));
  }
}

TEST_CASE("hard: what stops and begins again for another requester is not said to run on") {
  CHECK(cell(R"(roots: {Guard: {priority: 20}, Work: {priority: 10}}
groups:
  Guard: {needs: [Legs], tasks: {Brake: {}, Legs: {optional: true}}}
  Brake: {packs: {free: {Mind: {}}, firm: {Legs: {}}}}
  Work: {needs: [Legs], tasks: [Legs]}
  Mind: {}
  Legs: {stop: true}
)",
             "Work", "Guard")
            .starts_with("hard: Guard takes at once what Work holds. Work stops. Legs stops, and begins again, but not "
                         "for Work.\nstops Work\nagain Legs\nscenario:"));
}

TEST_CASE("hard: nothing of the first one is taken for good, but something stops for another one of its tasks") {
  CHECK(cell_words(R"(states: {Box: {values: [away, there], initial: away, external: true}}
roots: {Carry: {priority: 20}, Tidy: {priority: 10}}
groups:
  Tidy: {tasks: {Carry: {}, Sort: {}, Sweep: {optional: true}}}
  Carry: {when: [Box == there], needs: [Hand]}
  Sort: {needs: [Arm]}
  Sweep: {needs: [Arm]}
  Hand: {}
  Arm: {}
)",
                   "Tidy", "Carry") == "hard: When Carry is requested, Tidy loses groups at once. Sweep stops, and "
                                       "begins again. From outside: Box == "
                                       "there.");
}

TEST_CASE("soft: the first one is pushed, and something of it stops meanwhile") {
  CHECK(cell(R"(states: {Pose: {values: [moving, still], initial: still}}
roots: {Film: {priority: 20}, Walk: {priority: 10}}
groups:
  Film: {when: [Pose == still], stay: [Pose >= moving], needs: [Eye]}
  Walk:
    providers:
      - {name: walking, needs: [Legs, Arms], sets: [Pose == moving], tasks: [Legs, Arms]}
      - {name: halting, needs: [Legs], causing: [Pose == still within 2 s], tasks: [Legs]}
  Legs: {}
  Arms: {}
  Eye: {}
)",
             "Walk", "Film")
            .starts_with("soft: Film waits. Walk is pushed to halting for Pose == still, within 2 s. Then Film runs. "
                         "Arms stops.\n"));
}

TEST_CASE("never: the first one stops too where a unit of both waits") {
  CHECK(cell(R"(states: {Link: {values: [down, up], initial: down}}
roots: {Plan: {priority: 10}, Connect: {priority: 20}}
groups:
  Plan: {tasks: [Lift, Send]}
  Connect: {sets: [Link]}
  Lift: {needs: [Arm], tasks: [Arm]}
  Send: {when: [Link == up], needs: [Radio], tasks: [Radio]}
  Arm: {}
  Radio: {}
)",
             "Lift", "Send")
            .starts_with("never: Lift and Arm stop. Send does not run. Send waits (Plan>Send): until Link == up, which "
                         "no enabled provider promises.\nstops Lift Arm\nscenario:"));
}

TEST_CASE("waits: what stops when the second is requested is named before") {
  CHECK(cell_words(R"(states: {Load: {values: [none, box], initial: none, external: true}}
roots: {Lift: {priority: 20}, Send: {priority: 10}}
groups:
  Lift:
    providers:
      - {name: free, when: [Load == none], needs: [Arm, Leg], tasks: [Arm, Leg]}
      - {name: firm, needs: [Arm], tasks: [Arm]}
  Send: {when: [Load == box], needs: [Arm], tasks: [Arm]}
  Arm: {}
  Leg: {}
)",
                   "Lift", "Send") ==
        "waits: Leg stops. Send is queued, and runs when Lift is done. From outside: Load == box. Send waits "
        "(root>Send): Arm, which it needs, is held by Lift>Arm, and root>Lift (priority 20) goes before root>Send "
        "(priority 10).");
}

TEST_CASE("hard, soft: what runs for the second is named where it takes over") {
  const auto guard = [](const std::string& when) {
    return cell_words(fmt::format(R"(states: {{Pose: {{values: [moving, still], initial: still}}}}
roots: {{Guard: {{priority: 20}}, Work: {{priority: 10}}}}
groups:
  Guard: {{tasks: [Brake]}}
  Brake: {{{}needs: [Wheels], tasks: [Wheels]}}
  Work:
    providers:
      - {{name: going, needs: [Wheels], sets: [Pose == moving], tasks: [Wheels]}}
      - {{name: halting, needs: [Wheels], causing: [Pose == still within 2 s], tasks: [Wheels]}}
  Wheels: {{}}
)",
                                  when),
                      "Work", "Guard");
  };
  const std::string over = " Work stops. Wheels runs on, but not for Work any more.";
  CHECK(guard("") == "hard: Brake, which runs for Guard, takes at once what Work holds." + over);
  CHECK(guard("when: [Pose == still], ") ==
        "soft: Guard runs at once. What it requests waits. Work is pushed to halting for Pose == still, within 2 s. "
        "Then Brake, which runs for Guard, takes over." +
            over);
}

} // namespace director::tests
