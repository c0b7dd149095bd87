// SPDX-License-Identifier: MIT
#include "compiler/graph/graph.hpp"
#include "compiler/page/facts/facts.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <catch2/catch.hpp>

namespace director::tests {

namespace {

compiler::Json facts(const std::string& behaviour) {
  const Compiled compiled = compile("behaviour: test\nlanguage: 1\n" + behaviour);
  compiler::Json out = compiler::Json::object({});
  compiler::add_page_facts(out, compiled.model, compiler::make_graph(compiled.model), "test.yaml");
  return out;
}

/// `Kick waits for Motion == still of Walk.halting`
std::vector<std::string> possible_pushes(const std::string& behaviour) {
  const Compiled c = compile("behaviour: test\nlanguage: 1\n" + behaviour);
  std::vector<std::string> out;
  for (const compiler::Graph::Causing& row :
       compiler::with_possible_pushes(c.model, compiler::make_graph(c.model)).causing)
    out.push_back(c.model.full_name(row.waiter) + " waits for " + c.model.conditions[row.condition.id].text + " of " +
                  c.model.full_name(row.causer));
  return out;
}

/// Kick and Walk with these priorities; the requests of Kick.
std::string kicker(const std::string& kick, const std::string& walk, const std::string& with) {
  return "states: {Motion: {values: [moving, still], initial: moving}}\nroots: {Kick: {" + kick + "}, Walk: {" + walk +
         "}}\ngroups:\n  Kick: {" + with +
         "}\n  Walk:\n    providers:\n      - {name: walking, needs: [Legs], sets: [Motion == moving]}\n"
         "      - {name: halting, needs: [Legs], causing: [Motion == still]}\n  Legs: {}\n";
}

} // namespace

TEST_CASE("a waiting task may push what it goes before") {
  CHECK(possible_pushes(kicker("priority: 2", "priority: 1", "when: [Motion == still], needs: [Legs]")) ==
        std::vector<std::string>{"Kick waits for Motion == still of Walk.halting"});
}

TEST_CASE("a waiting task does not push what priorities put before it, or beside it") {
  for (const char* const walk : {"priority: 3", "priority: 2"})
    CHECK(possible_pushes(kicker("priority: 2", walk, "when: [Motion == still], needs: [Legs]")).empty());
}

TEST_CASE("a waiting task does not push what runs only while it could not") {
  const std::string text = "states:\n  Estop: {values: [pressed, clear], initial: clear, external: true}\n"
                           "  Motion: {values: [moving, still], initial: moving}\n"
                           "roots: {Freeze: {priority: 2}, Park: {priority: 3}, Walk: {priority: 1}}\ngroups:\n"
                           "  Freeze: {when: [Estop == pressed, Motion == still]}\n  Park: {when: [Motion == still]}\n"
                           "  Walk: {providers: [{name: walking, sets: [Motion == moving]}, "
                           "{name: halting, when: [Estop == clear], causing: [Motion == still]}]}\n";
  CHECK(possible_pushes(text) == std::vector<std::string>{"Park waits for Motion == still of Walk.halting"});
}

TEST_CASE("what a need waits for, the task pushes for that needs it") {
  const std::string foot = "  Foot: {when: [Motion == still]}\n";
  CHECK(possible_pushes(kicker("priority: 2", "priority: 1", "needs: [Foot]") + foot) ==
        std::vector<std::string>{"Foot waits for Motion == still of Walk.halting"});
  CHECK(possible_pushes(kicker("priority: 1", "priority: 2", "needs: [Foot]") + foot).empty());
}

TEST_CASE("a task that waits for one that waits itself pushes along the chain") {
  CHECK(possible_pushes(R"(states:
  Motion: {values: [moving, still], initial: moving}
  Arm: {values: [out, folded], initial: out}
roots: {Load: {priority: 3}, Walk: {priority: 2}, Reach: {priority: 1}}
groups:
  Load: {when: [Arm == folded]}
  Reach:
    providers:
      - {name: reaching, needs: [Hand], sets: [Arm == out]}
      - {name: folding, when: [Motion == still], needs: [Hand], causing: [Arm == folded]}
  Walk:
    providers:
      - {name: walking, needs: [Legs], sets: [Motion == moving]}
      - {name: halting, needs: [Legs], causing: [Motion == still]}
  Hand: {}
  Legs: {}
)") == std::vector<std::string>{"Load waits for Arm == folded of Reach.folding",
                                "Reach.folding waits for Motion == still of Walk.halting"});
}

TEST_CASE("of two tasks of the program the table shows which goes first, by what priorities, and over what") {
  CHECK(to_lines(facts(R"(roots: {GetUp: {priority: 20}, Walk: {priority: 10}}
groups: {GetUp: {needs: [Legs]}, Walk: {needs: [Legs], tasks: [Legs]}, Legs: {needs: [Knee]}, Knee: {}}
)")["takes"]) == R"([
  {
    "winner": "GetUp",
    "loser": "Walk",
    "by": "priority",
    "winner_priorities": [
      20
    ],
    "loser_priorities": [
      10
    ],
    "words": "priority 20 before 10",
    "over": [
      "Legs"
    ]
  }
]
)");
}

TEST_CASE("a group that one of the two reaches past the one that they contend for is listed beside it") {
  const compiler::Json takes = facts(R"(roots: {Deliver: {priority: 30}, Recharge: {priority: 20}}
groups:
  Deliver: {packs: {go: [Drive], grab: [Grasp]}}
  Recharge: {tasks: [Drive]}
  Drive: {needs: [Wheels], tasks: [Wheels]}
  Grasp: {needs: [Wheels]}
  Wheels: {needs: [Motor]}
  Motor: {}
)")["takes"];
  REQUIRE(takes.items().size() == 1);
  CHECK(to_line(takes.items().front()["over"]) == R"(["Drive","Wheels"])");
}

TEST_CASE("a task takes also what another one holds past a group that is only needed") {
  CHECK(
      to_line(facts(R"(roots: {Inspect: {priority: 2}, Carry: {priority: 1}}
groups: {Inspect: {needs: [Pump]}, Carry: {needs: [Press]}, Press: {needs: [Pump]}, Pump: {}}
)")["takes"]) ==
      R"([{"winner":"Inspect","loser":"Carry","by":"priority","winner_priorities":[2],"loser_priorities":[1],"words":"priority 2 before 1","over":["Pump"]}])");
}

TEST_CASE("a task takes nothing that is granted together with it, only what that leads to") {
  CHECK(
      to_line(facts(R"(roots: [Play]
groups:
  Play: {tasks: {Walk: {priority: 9}, Legs: {priority: 2}}}
  Walk: {tasks: [Legs]}
  Legs: {needs: [Knee], tasks: [Foot]}
  Knee: {}
  Foot: {}
)")["takes"]) ==
      R"([{"requester":"Play","winner":"Walk","loser":"Legs","by":"priority","winner_priorities":[9],"loser_priorities":[2],"words":"priority 9 before 2","over":["Foot"]}])");
}

TEST_CASE("what is optional gives way at its requester, whatever its priority") {
  CHECK(
      to_line(facts(R"(roots: [Play]
groups:
  Play:
    packs:
      all: {Kick: {apart: true}, Look: {optional: true, priority: 5}}
  Kick: {needs: [Head]}
  Look: {needs: [Head]}
  Head: {}
)")["takes"]) ==
      R"([{"requester":"Play","winner":"Kick","loser":"Look","by":"optional","winner_priorities":[0],"loser_priorities":[5],"words":"where the second is optional","over":["Head"]}])");
}

TEST_CASE("of two tasks the table names only the ranks by which one goes before the other") {
  const auto words = [](const std::string& behaviour) {
    const compiler::Json all = facts(behaviour);
    std::string out;
    for (const compiler::Json& take : all["takes"].items())
      out += take["winner"].as_text() + " before " + take["loser"].as_text() + ": " + take["words"].as_text() + "\n";
    return out;
  };
  CHECK(words(R"(roots: {Kick: {priority: {normal: 10, firm: 30, urgent: 80}}, Walk: {priority: 20}}
groups: {Kick: {needs: [Legs]}, Walk: {needs: [Legs]}, Legs: {}}
)") == "Kick before Walk: priority 30 or 80 before 20\nWalk before Kick: priority 20 before 10\n");
  CHECK(words(R"(roots: {Play: {priority: 5}, Cheer: {priority: 50, optional: true}, Rest: {priority: -3}}
groups: {Play: {tasks: {Look: {optional: true}}}, Look: {needs: [Head]}, Cheer: {needs: [Head]}, Rest: {needs: [Head]}, Head: {}}
)") == "Cheer before Play: priority 50 optional before 5 (something below it optional)\n"
       "Rest before Play: where something below the second is optional\n"
       "Rest before Cheer: where the second is optional\n");
}

TEST_CASE("the table names the members of a unit with which a task goes before one that is apart") {
  const auto words = [](const std::string& tasks) {
    const compiler::Json all = facts("roots: [Play]\ngroups:\n  Play: {" + tasks +
                                     "}\n  Lift: {}\n  Carry: {needs: [Arm]}\n  Grip: {needs: [Arm]}\n  Arm: {}\n");
    std::string out;
    for (const compiler::Json& take : all["takes"].items())
      out += take["winner"].as_text() + " before " + take["loser"].as_text() + ", " + take["by"].as_text() + ": " +
             take["words"].as_text() + "\n";
    return out;
  };
  const std::string led = "Grip before Carry, unit: where Grip is granted together with Lift (priority 5)\n";
  CHECK(words("tasks: {Lift: {priority: 5}, Carry: {apart: true, priority: 2}, Grip: {}}") ==
        "Carry before Grip, priority: priority 2 before 0, unless Grip is granted together with Lift (priority 5)\n" +
            led);
  CHECK(words("tasks: {Lift: {priority: 5}, Carry: {apart: true, priority: 5}, Grip: {}}") ==
        "Carry before Grip, priority: priority 5 before 0, unless Grip is granted together with Lift (priority 5, if "
        "older)\n"
        "Grip before Carry, unit: where Grip is granted together with Lift (priority 5, if older)\n");
  CHECK(words("packs: {go: {Lift: {priority: 5}, Carry: {apart: true, priority: 2}, Grip: {}}}") == led);
  CHECK(words("tasks: {Lift: {priority: 5}, Carry: {apart: true}, Grip: {}}").empty()); // equals take nothing
  CHECK(words("tasks: {Lift: {priority: 5, apart: true}, Carry: {apart: true, priority: 2}, Grip: {}}") ==
        "Carry before Grip, priority: priority 2 before 0\n");
}

TEST_CASE("a cell of two groups that are asserted to change over softly has the verdict") {
  const compiler::Json transitions = facts(R"(roots: {GetUp: {priority: 20}, Walk: {priority: 10}}
groups: {GetUp: {needs: [Legs]}, Walk: {needs: [Legs]}, Legs: {}}
assertions: [soft: {from: Walk, to: GetUp}]
)")["transitions"];
  const std::vector<compiler::Json>& rows = transitions["rows"].items();
  REQUIRE(rows.size() == 2);
  CHECK(
      rows[1]["cells"].items()[0]["words"].as_text() ==
      "GetUp takes at once what Walk holds. Walk stops. It is asserted that granting GetUp is soft for Walk: refuted.");
  CHECK(rows[1]["cells"].items()[0]["asserted"].as_text() == "refuted");
  CHECK(rows[0]["cells"].items()[1]["asserted"].is_null());
}

TEST_CASE("each assertion has its verdict and why, one that is refuted a scenario") {
  const compiler::Json verdicts = facts(R"(roots: {GetUp: {priority: 20}, Walk: {priority: 10}}
groups: {GetUp: {needs: [Legs]}, Walk: {needs: [Legs]}, Legs: {}}
assertions:
  - never_together: [GetUp, Walk]
  - soft: {from: Walk, to: GetUp}
)")["verdicts"];
  REQUIRE(verdicts.items().size() == 2);
  CHECK(
      to_line(verdicts.items()[0]) ==
      R"({"assertion":"never_together [GetUp, Walk]","verdict":"proven","why":"no two of them can be granted without `Legs`, and a group has one holder"})");
  CHECK(verdicts.items()[1]["verdict"].as_text() == "refuted");
  CHECK(verdicts.items()[1]["scenario"].as_text().starts_with("scenario: \"refuted: soft {from: Walk, to: GetUp}\"\n"));
}

TEST_CASE("the matrix has a row and a column for each group that requests something or needs it") {
  const compiler::Json transitions = facts(R"(roots: {GetUp: {priority: 20}, Walk: {priority: 10}}
groups: {GetUp: {needs: [Legs]}, Walk: {needs: [Legs]}, Legs: {}}
)")["transitions"];
  CHECK(
      to_line(transitions["rows"].items()[1]) ==
      R"({"group":"Walk","reached":true,"words":"Requested by way of Walk.","chain":[],"states":[],"given":[],"cells":[)"
      R"({"kind":"hard","words":"GetUp takes at once what Walk holds. Walk stops.","stops":["Walk"],"scenario":[0,3,2,1,4,5,11,7,9,8]},)"
      R"({"kind":"same chain","words":"It is the same group."}]})");
}

TEST_CASE("a group that nothing requests has no row and no column, and is named beside the matrix") {
  const compiler::Json transitions = facts(R"(roots: [Walk]
groups: {Walk: {needs: [Legs]}, Swim: {needs: [Legs]}, Dive: {tasks: [Swim]}, Legs: {}}
)")["transitions"];
  REQUIRE(transitions["rows"].items().size() == 1);
  CHECK(transitions["rows"].items()[0]["group"].as_text() == "Walk");
  CHECK(transitions["rows"].items()[0]["cells"].items().size() == 1);
  CHECK(to_line(transitions["not_requested"]) == R"(["Swim","Dive"])");
  CHECK(transitions["left_out"].is_null());
}

TEST_CASE("more takes than a page can hold are left out, and it is reported") {
  std::string roots, groups;
  for (std::size_t i = 0; i <= 200; ++i) {
    roots += "  T" + std::to_string(i) + ": {priority: " + std::to_string(i) + "}\n";
    groups += "  T" + std::to_string(i) + ": {needs: [Legs]}\n";
  }
  const compiler::Json all = facts("roots:\n" + roots + "groups:\n  Legs: {}\n" + groups);
  CHECK(all["takes"].items().empty());
  CHECK(all["takes_left_out"].as_text() ==
        "What tasks may take from each other is not listed here, as there are more than 20000 pairs of them; "
        "`directorc graph --view=takes --focus GROUP --depth 1` draws those of a group.");
  CHECK(facts("roots: [Walk]\ngroups: {Walk: {}}\n")["takes_left_out"].is_null());
}

TEST_CASE("each task of a long chain of promises pushes only what it waits for") {
  constexpr int length = 1'000;
  std::string states, roots, groups;
  for (int i = 0; i < length; ++i) {
    const std::string here = std::to_string(i), when = i == 0 ? "" : "when: [S" + std::to_string(i - 1) + " == b], ";
    states += "  S" + here + ": {values: [a, b], initial: a}\n";
    roots += "  G" + here + ": {priority: " + here + "}\n";
    groups += "  G" + here + ":\n    providers:\n      - {name: p, " + when + "needs: [L], sets: [S" + here +
              " == a]}\n      - {name: q, " + when + "needs: [L], causing: [S" + here + " == b]}\n";
  }
  CHECK(possible_pushes("states:\n" + states + "roots:\n" + roots + "groups:\n" + groups + "  L: {}\n").size() ==
        2 * (length - 1));
}

} // namespace director::tests
