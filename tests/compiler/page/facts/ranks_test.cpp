// SPDX-License-Identifier: MIT
#include "compiler/page/facts/ranks.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace director::tests {

namespace {

std::string about(std::size_t count) {
  std::string out = "behaviour: many\nlanguage: 1\nroots: [G0]\ngroups:\n";
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const std::string here = std::to_string(i), next = std::to_string(i + 1);
    out += "  G" + here + ": {tasks: [G" + next + "]}\n";
  }
  return out + "  G" + std::to_string(count - 1) + ": {}\n";
}

/// The page's text about two groups, a line for each decision.
std::string told_of(const std::string& behaviour, const std::string& first, const std::string& second) {
  const Compiled c = compile("behaviour: test\nlanguage: 1\n" + behaviour);
  const compiler::Json ranks = compiler::ranks_json(c.model);
  const compiler::GroupId a = c.group(first), b = c.group(second);
  REQUIRE(b <= a); // a row has those before it
  const auto place = static_cast<std::size_t>(ranks["pairs"].items()[a.value].items()[b.value].as_number());
  const compiler::Json& answer = ranks["answers"].items()[place];
  std::string out = answer["leads"].is_null() ? "" : answer["leads"].as_text() + " leads\n";
  for (const compiler::Json& code : answer["decisions"].items()) {
    const compiler::Json& decision = ranks["decisions"].items()[static_cast<std::size_t>(code.as_number() / 2)];
    std::string wins = decision["goes_first"].as_text();
    if (code.as_number() % 2 == 1 && wins != "equal") wins = wins == "first" ? "second" : "first";
    out += wins + ", " + decision["words"].as_text() + "\n";
  }
  return out;
}

} // namespace

TEST_CASE("two groups below two roots are decided by the priorities of these") {
  const std::string behaviour = R"(roots: {Rescue: {priority: 9}, Play: {priority: 1}}
groups:
  Kick: {needs: [Legs]}
  GetUp: {needs: [Legs]}
  Rescue: {tasks: [GetUp]}
  Play: {tasks: {Kick: {priority: 50}}}
  Legs: {}
)";
  CHECK(told_of(behaviour, "GetUp", "Kick") == "first, the program: Rescue (priority 9) before Play (priority 1)\n");
  CHECK(told_of(behaviour, "Legs", "Legs") == "second, the program: Rescue (priority 9) before Play (priority 1)\n");
}

TEST_CASE("each level is compared, also with the other side's optional one") {
  CHECK(told_of(R"(roots: [Play]
groups:
  Play:
    packs:
      near: {Kick: {levels: {calm: {priority: 5}, firm: {priority: 20}}}, Look: {levels: {must: {priority: 10}, may: {priority: 30, optional: true}}}}
  Kick: {}
  Look: {}
)",
                "Look", "Kick") ==
        "first, Play: Look (priority 10) before Kick (priority 5), together or not at all\n"
        "second, Play: Kick (priority 20) before Look (priority 10), together or not at all\n"
        "second, Play: Kick (priority 5) before Look (priority 30, optional)\n"
        "second, Play: Kick (priority 20) before Look (priority 30, optional)\n");
}

TEST_CASE("two of one pack with the same priority are equal, and granted together unless one is apart") {
  const auto pack = [](const std::string& look) {
    return "roots: [Play]\ngroups:\n  Play: {tasks: {Kick: {}, Look: {" + look + "}}}\n  Kick: {}\n  Look: {}\n";
  };
  CHECK(told_of(pack(""), "Look", "Kick") ==
        "equal, Play: Kick (priority 0) and Look (priority 0) are equal, together or not at all\n");
  CHECK(told_of(pack("apart: true"), "Look", "Kick") ==
        "equal, Play: Kick (priority 0) and Look (priority 0) are equal\n");
}

TEST_CASE("tasks of two packs are never both requested") {
  CHECK(told_of(R"(roots: [Play]
groups:
  Play: {packs: {attack: {Kick: {priority: 2}}, defend: {Walk: {priority: 1}}}}
  Kick: {}
  Walk: {}
)",
                "Walk", "Kick") == "second, Play: Kick (priority 2) before Walk (priority 1), never both at once\n");
}

TEST_CASE("a task of two packs is never requested beside what is in one of them at the priority of the other") {
  CHECK(told_of(R"(roots: [Play]
groups:
  Play: {packs: {attack: {Kick: {priority: 1}, Walk: {priority: 2, apart: true}}, defend: {Kick: {priority: 3}}}}
  Kick: {}
  Walk: {}
)",
                "Walk", "Kick") == "first, Play: Walk (priority 2) before Kick (priority 1)\n"
                                   "second, Play: Kick (priority 3) before Walk (priority 2), never both at once\n");
}

TEST_CASE("a task that is optional only in another pack is optional there alone") {
  const std::string text = told_of(R"(roots: [Play]
groups:
  Play:
    providers:
      - {name: early, packs: {go: {A: {priority: 20}, B: {optional: true}}}}
      - {name: late, packs: {go: [B]}}
  A: {}
  B: {}
)",
                                   "B", "A");
  CHECK(text == "second, Play: A (priority 20) before B (priority 0), never both at once\n"
                "second, Play: A (priority 20) before B (priority 0, optional)\n");
}

TEST_CASE("what is optional gives way, itself or below the task that is compared") {
  CHECK(told_of(R"(roots: {Play: {priority: 9}, Idle: {priority: 1}}
groups:
  Play: {tasks: {Look: {optional: true}}}
  Idle: {tasks: [Rest]}
  Look: {}
  Rest: {}
)",
                "Rest", "Look") ==
        "first, the program: Idle (priority 1) before Play (priority 9, something below it optional)\n");
}

TEST_CASE(
    "of two of which one leads to the other, the one above goes first; they meet where something else leads there") {
  const std::string behaviour = R"(roots: {Play: {priority: 1}, Test: {priority: 2}}
groups:
  Play: {tasks: [Walk]}
  Walk: {tasks: [Legs]}
  Legs: {}
  Test: {tasks: [Legs]}
)";
  CHECK(told_of(behaviour, "Walk", "Play") == "second leads\n");
  CHECK(told_of(behaviour, "Legs", "Walk") ==
        "second leads\nfirst, the program: Test (priority 2) before Play (priority 1)\n");
}

TEST_CASE("two of which one chain passes what the other one holds do not meet") {
  CHECK(told_of(R"(roots: [Play]
groups:
  Play: {tasks: [Attack, Defend]}
  Attack: {tasks: [Walk]}
  Defend: {tasks: [Walk]}
  Walk: {needs: [Left, Right]}
  Left: {}
  Right: {}
)",
                "Right", "Left") == "equal, Walk: Left (needed) and Right (needed) are equal\n");
}

TEST_CASE("what is granted together, or needed, goes before what others of the same requester request") {
  const auto legs = [](const std::string& play) {
    return told_of("roots: [Play]\ngroups:\n  Play: " + play + "\n  Walk: {tasks: [Legs]}\n  Legs: {}\n", "Legs",
                   "Legs");
  };
  CHECK(legs("{tasks: {Walk: {priority: 9}, Legs: {priority: 2}}}") ==
        "first, Play: Legs (priority 2) before what Walk (priority 9) requests, as both are granted together\n");
  CHECK(legs("{needs: [Legs], tasks: {Walk: {priority: 9}}}") ==
        "first, Play: Legs (needed) before what Walk (priority 9) requests, as Play runs only with it\n");
  CHECK(legs("{tasks: {Walk: {priority: 9}, Legs: {priority: 2, apart: true}}}") ==
        "second, Play: Walk (priority 9) before Legs (priority 2)\n");
  CHECK(legs("{packs: {one: {Walk: {priority: 9}}, other: {Legs: {priority: 2}}}}") ==
        "second, Play: Walk (priority 9) before Legs (priority 2), never both at once\n");
}

TEST_CASE("what a member of a unit needs, or a need of the requester needs, goes before what others of it request") {
  const auto legs = [](const std::string& play, const char* first = "Legs", const char* second = "Legs") {
    return told_of("roots: [Play]\ngroups:\n  Play: " + play +
                       "\n  Walk: {tasks: [Step]}\n  Step: {tasks: [Legs]}\n  Stand: {needs: [Hips]}\n"
                       "  Hips: {needs: [Legs]}\n  Legs: {}\n",
                   first, second);
  };
  CHECK(legs("{tasks: {Walk: {priority: 9}, Stand: {priority: 2}}}") ==
        "second, Play: what Stand (priority 2) needs before what Walk (priority 9) requests, as both are granted "
        "together\n");
  CHECK(legs("{tasks: {Walk: {priority: 9}, Stand: {priority: 2}}}", "Hips", "Step") ==
        "first, Play: what Stand (priority 2) needs before what Walk (priority 9) requests, as both are granted "
        "together\nsecond, Play: Walk (priority 9) before Stand (priority 2), together or not at all\n");
  CHECK(legs("{needs: [Stand], tasks: {Walk: {priority: 9}}}") ==
        "second, Play: what Stand (needed) needs before what Walk (priority 9) requests, as Play runs only with it\n");
  CHECK(legs("{needs: [Stand], tasks: {Legs: {priority: 9}}}") ==
        "first, Play: Legs (priority 9) before Stand (needed)\n"
        "second, Play: what Stand (needed) needs before Legs (priority 9), as Play runs only with it\n");
  CHECK(legs("{tasks: {Walk: {priority: 9}, Stand: {priority: 2, apart: true}}}") ==
        "first, Play: Walk (priority 9) before Stand (priority 2)\n");
}

TEST_CASE("a member of a unit goes before what is behind another member, if that one is requested") {
  const auto pack = [](const std::string& tasks, const char* first, const char* second) {
    return told_of("roots: [Pack]\ngroups:\n  Pack: {" + tasks +
                       "}\n  Lift: {}\n  Hold: {}\n  Sort: {tasks: [Pick]}\n  Pick: {tasks: [Grip]}\n"
                       "  Grip: {needs: [Palm]}\n  Palm: {tasks: [Nail]}\n  Nail: {}\n  Spot: {tasks: [Nail, Palm]}\n",
                   first, second);
  };
  const std::string any =
      "tasks: {Lift: {priority: {hurried: 50, calm: 0}}, Sort: {priority: 20, apart: true}, Grip: {}}";
  const std::string with_lift =
      "Pack: Grip (priority 0) before Sort (priority 20), as Grip is granted together with Lift (priority 50)\n";
  const std::string without_lift =
      "Pack: Sort (priority 20) before Grip (priority 0), unless Grip is granted together with Lift (priority 50)\n";
  CHECK(pack(any, "Grip", "Grip") == "second, " + without_lift + "first, " + with_lift);
  CHECK(pack(any, "Grip", "Sort") == "second leads\nsecond, " + without_lift + "first, " + with_lift);
  CHECK(pack(any, "Grip", "Pick") == "second leads\nsecond, " + without_lift + "first, " + with_lift);
  // Its needs are granted with it, and their requests are not.
  CHECK(pack(any, "Palm", "Sort") == "second leads\nsecond, " + without_lift +
                                         "first, Pack: what Grip (priority 0) needs before Sort (priority 20), as Grip "
                                         "is granted together with Lift (priority 50)\n");
  CHECK(pack(any, "Nail", "Sort") == "second leads\nsecond, Pack: Sort (priority 20) before Grip (priority 0)\n");
}

TEST_CASE(
    "a member goes first in each pack that requests who stands before it, and where that is older if it is equal") {
  const auto grip = [](const std::string& tasks) {
    return told_of("roots: [Pack]\ngroups:\n  Pack: {" + tasks +
                       "}\n  Lift: {}\n  Hold: {}\n  Sort: {tasks: [Grip]}\n  Grip: {}\n",
                   "Grip", "Grip");
  };
  const std::string by_rank = "second, Pack: Sort (priority 20) before Grip (priority 0)";
  const std::string led = "first, Pack: Grip (priority 0) before Sort (priority 20), as Grip is granted together with ";
  // A pack is requested as a whole.
  CHECK(grip("packs: {whole: {Lift: {priority: 50}, Hold: {priority: 20}, Sort: {priority: 20, apart: true}, Grip: "
             "{}}}") == led + "Lift (priority 50) or Hold (priority 20, if older)\n");
  CHECK(grip("packs: {whole: {Lift: {levels: {firm: {priority: 50}, spare: {priority: 50, optional: true}}}, Sort: "
             "{priority: 20, apart: true}, Grip: {}}}") ==
        by_rank + ", unless Grip is granted together with Lift (priority 50)\n" + led + "Lift (priority 50)\n");
  CHECK(grip("packs: {whole: {Hold: {priority: 20}, Sort: {priority: 20, apart: true}, Grip: {}}}") ==
        by_rank + ", unless Grip is granted together with Hold (priority 20, if older)\n" + led +
            "Hold (priority 20, if older)\n");
  CHECK(grip("tasks: {Lift: {priority: 50}, Sort: {apart: true}, Grip: {}}") ==
        "equal, Pack: Sort (priority 0) and Grip (priority 0) are equal; of two that request it, Grip goes first where "
        "granted together with Lift (priority 50)\n");
  // None of these brings it forward.
  CHECK(grip("tasks: {Lift: {priority: 50, apart: true}, Hold: {priority: 10}, Sort: {priority: 20, apart: true}, "
             "Grip: {}}") == by_rank + "\n");
  CHECK(grip("packs: {fast: {Lift: {priority: 50}, Grip: {}}, slow: {Sort: {priority: 20, apart: true}, Grip: {}}}") ==
        by_rank + "\n");
}

TEST_CASE("what one provider needs and another one requests apart goes first only where it is needed") {
  CHECK(told_of(R"(roots: [Play]
groups:
  Play: {providers: [{name: near, needs: [Walk], tasks: {Walk: {}, Legs: {apart: true}}}, {name: far, needs: [Legs], tasks: [Walk, Legs]}]}
  Walk: {tasks: [Legs]}
  Legs: {}
)",
                "Legs", "Legs") ==
        "equal, Play: Walk (priority 0) and Legs (priority 0) are equal, together or not at all\n"
        "first, Play: Legs (priority 0) before what Walk (priority 0) requests, as both are granted together\n"
        "first, Play: Legs (priority 0) before what Walk (priority 0) requests, as Play.far runs only with it\n");
}

TEST_CASE("what needs the first of two is the provider, where another one of its group runs without") {
  const auto legs = [](const std::string& more) {
    return told_of("roots: [Play]\ngroups:\n  Play: {providers: [{name: near, needs: [Legs]}, {name: far, tasks: "
                   "{Walk: {priority: 9}}}" +
                       more + "]}\n  Walk: {tasks: [Legs]}\n  Legs: {}\n",
                   "Legs", "Legs");
  };
  CHECK(legs("") == "first, Play: Legs (needed) before what Walk (priority 9) requests, as Play.near runs only with "
                    "it, never both at once\n");
  CHECK(legs(", {name: lying, needs: [Legs]}") ==
        "first, Play: Legs (needed) before what Walk (priority 9) requests, as Play.near and Play.lying run only with "
        "it, never both at once\n");
}

TEST_CASE(
    "a request remains while its requester changes to another provider, and then stands beside what that one needs") {
  const auto legs = [](const std::string& far) {
    return told_of(
        "roots: [Play]\ngroups:\n  Play: {providers: [{name: near, tasks: {Walk: {priority: 9}}}, {name: far" + far +
            "}]}\n  Walk: {tasks: [Legs]}\n  Legs: {}\n",
        "Legs", "Legs");
  };
  CHECK(legs(", needs: [Legs]") ==
        "first, Play: Legs (needed) before what Walk (priority 9) requests, as Play.far runs only with it, never both "
        "at once\n");
  CHECK(legs(", tasks: [Legs]") == "second, Play: Walk (priority 9) before Legs (priority 0), never both at once\n");
}

TEST_CASE("what one provider needs and requests as optional gives way once another provider has the request") {
  const auto head = [](const std::string& waving) {
    return told_of("roots: {Walk: {priority: 10}, Look: {priority: 10}}\ngroups:\n  Walk: {providers: [{name: looking, "
                   "needs: [Head], tasks: {Head: {optional: true}}}, {name: waving" +
                       waving + "}]}\n  Look: {needs: [Head], tasks: [Head]}\n  Head: {}\n",
                   "Head", "Head");
  };
  const std::string equal = "equal, the program: Walk (priority 10) and Look (priority 10) are equal\n";
  CHECK(head(", needs: [Head]") == equal);
  CHECK(head("") == equal + "second, the program: Look (priority 10) before Walk (priority 10, something below it "
                            "optional)\n");
}

TEST_CASE("of what several request, each two have what decides between them") {
  const Compiled c = compile(R"(behaviour: test
language: 1
roots: {Rescue: {priority: 9}, Play: {priority: 1}, Legs: {priority: 5}}
groups: {Rescue: {tasks: [Legs]}, Play: {tasks: [Legs]}, Legs: {}}
)");
  CHECK(to_line(compiler::ranks_json(c.model)["contended"]) ==
        R"([{"group":"Legs","rivals":[{"second":"Rescue","decisions":[1]},{"second":"Play","decisions":[3]},)"
        R"({"first":"Rescue","second":"Play","decisions":[4]}]}])");
}

TEST_CASE("of more groups than a page can hold not every two are compared, and it is reported") {
  const Compiled c = compile(about(compiler::most_compared + 1));
  const compiler::Json ranks = compiler::ranks_json(c.model);
  CHECK(ranks["left_out"].as_text() ==
        "Not every two of 501 groups are compared here, as there are more than 500; those "
        "that several request are.");
  CHECK(ranks["pairs"].items().empty());
}

TEST_CASE("if more decides between two groups than a page can hold, no two are compared, and it is reported") {
  const Compiled c = compile(R"(behaviour: test
language: 1
roots: {Rescue: {priority: 9}, Play: {priority: 1}, Look: {priority: 5}}
groups: {Rescue: {needs: [Legs]}, Play: {tasks: [Legs]}, Look: {}, Legs: {}}
)");
  const auto decisions = [](const compiler::Json& ranks) {
    std::size_t out = 0;
    for (const compiler::Json& answer : ranks["answers"].items()) out += answer["decisions"].items().size();
    return out;
  };
  const compiler::Json all = compiler::ranks_json(c.model);
  CHECK(all["left_out"].is_null());
  CHECK(to_line(compiler::ranks_json(c.model, decisions(all))) == to_line(all));
  const compiler::Json some = compiler::ranks_json(c.model, decisions(all) - 1);
  CHECK(some["left_out"].as_text() ==
        fmt::format("Not every two groups are compared here, as there are more than {} decisions between them; those "
                    "that several request are.",
                    decisions(all) - 1));
  CHECK(some["pairs"].items().empty());
  CHECK(some["answers"].items().empty());
  CHECK(to_line(some["contended"]) == to_line(all["contended"]));
}

TEST_CASE("of a group that very many request, they are not compared, and it is reported") {
  std::string roots, groups;
  for (std::size_t i = 0; i <= 200; ++i) {
    roots += "  T" + std::to_string(i) + ": {priority: " + std::to_string(i) + "}\n";
    groups += "  T" + std::to_string(i) + ": {needs: [Legs, " + (i < 2 ? "Head, " : "") + "Arms]}\n";
  }
  const Compiled c = compile("behaviour: many\nlanguage: 1\nroots:\n" + roots +
                             "groups:\n  Legs: {}\n  Head: {}\n  Arms: {}\n" + groups);
  const compiler::Json ranks = compiler::ranks_json(c.model);
  CHECK(ranks["left_out"].as_text() == "The requesters of Legs and Arms are not compared with each other, as there "
                                       "would be more than 20000 pairs, or more than 200000 decisions between them.");
  REQUIRE(ranks["contended"].items().size() == 1);
  CHECK(ranks["contended"].items().front()["group"].as_text() == "Head");
}

} // namespace director::tests
