// SPDX-License-Identifier: MIT
// Tests compiler/trace/permits.cpp, by replays of what was recorded by another version.
#include "tests/compiler/cli/world.hpp"

#include <catch2/catch.hpp>

namespace {

using director::tests::World;

const std::string cook = R"(behaviour: kitchen
language: 1
states:
  Heat: {range: [0, 100], initial: 0, external: true}
  Pot: {range: [0, 9], initial: 0}
roots: [Meal]
groups:
  Meal:
    providers:
      - {name: fast, packs: {both: {Cook: {}, Wash: {}}, one: {Wash: {}}}}
      - {name: slow, tasks: [Cook]}
  Cook: {stop: {sets: [Pot == 3]}, sets: [Pot <= 5]}
  Wash: {}
)";

/// The replay of a recording of `cook` by the behaviour with another text at one place.
std::string replayed_with(const std::string& before, const std::string& after) {
  World world;
  world.files.add("cook.yaml", cook);
  world.files.add("s.yaml", R"(scenario: a meal
behaviour: cook.yaml
given: {Pot: 7}
script:
  Meal.fast: {pack: both}
  Cook: {set: {Pot: 5}}
  Cook.stop: {set: {Pot: 3}}
steps:
  - request: Meal
  - set: {Heat: 80}
  - cancel: Meal
)");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  world.files.add("run.jsonl", world.outputs.files.at("run.jsonl"));
  std::string other = cook;
  REQUIRE(other.find(before) != std::string::npos);
  other.replace(other.find(before), before.size(), after);
  world.files.add("other.yaml", other);
  const int status = world.directorc({"replay", "run.jsonl", "--behaviour=other.yaml"});
  return std::to_string(status) + "\n" + world.err + world.out;
}

/// What is said of a version with the same tables, where only declarations differ.
std::string declared_otherwise(const std::string& at, const std::string& rest, const std::string& before) {
  return "1\nrun.jsonl:" + at + ", at 0.000000 s, cannot be replayed by `other.yaml`\n" + rest + "  " + before +
         "  it decides as the version that was recorded, but declares something else, or the line was changed\n";
}

TEST_CASE("what a version declares as the recorded one did is replayed") {
  const std::string same = "0\nrun.jsonl: 24 events, all the same\n";
  CHECK(replayed_with("Pot <= 5", "Pot <= 6") == same);
  CHECK(replayed_with("range: [0, 9]", "range: [0, 7]") == same);
}

TEST_CASE("a number outside of a state's range is not replayed, whether it was given, an input, or set by a body") {
  CHECK(replayed_with("range: [0, 9]", "range: [0, 6]") ==
        declared_otherwise("3: event 2",
                           "  recorded: given Pot 7\n"
                           "  replayed: `7` is no value of the state `Pot`: its values are the whole numbers from 0 to "
                           "6\n"
                           "  help: write one of them, or widen the `range`\n",
                           "1 event before it is the same\n"));
  CHECK(replayed_with("range: [0, 100]", "range: [0, 50]") ==
        declared_otherwise("18: event 17",
                           "  recorded: > set {Heat: 80}\n"
                           "  replayed: `80` is no value of the state `Heat`: its values are the whole numbers from 0 "
                           "to 50\n"
                           "  help: write one of them, or widen the `range`\n",
                           "16 events before it are the same\n"));
}

TEST_CASE("a value that a body or handler does not declare any more is not replayed") {
  CHECK(replayed_with("sets: [Pot <= 5]", "sets: [Pot == 4]") ==
        declared_otherwise("14: event 13",
                           "  recorded: assign Pot 5\n"
                           "  replayed: `Cook` sets `Pot` to `5`, which it does not declare\n"
                           "  help: what it declares is `Pot == 4`\n",
                           "12 events before it are the same\n"));
  CHECK(replayed_with("Pot == 3", "Pot == 2") ==
        declared_otherwise("24: event 23",
                           "  recorded: assign Pot 3\n"
                           "  replayed: the stop handler of `Cook` sets `Pot` to `3`, which it does not declare\n"
                           "  help: what it declares is `Pot == 2`\n",
                           "22 events before it are the same\n"));
}

TEST_CASE("what only another version has is told with its place") {
  const auto other = [](const std::string& at, const std::string& rest) {
    return "1\nrun.jsonl:" + at +
           ", at 0.000000 s, cannot be replayed by `other.yaml`, another version than the one recorded\n" + rest;
  };
  CHECK(replayed_with("both: {Cook: {}, Wash: {}}", "both: {Cook: {}}") ==
        other("9: event 8", "  recorded: ask Meal>Wash\n"
                            "  replayed: the pack `both` of `Meal.fast` has no task called `Wash`\n"
                            "  help: there is only `Cook`\n"
                            "  7 events before it are the same\n"));
  CHECK(replayed_with("both: {Cook: {}, Wash: {}}, one: {Wash: {}}", "all: {Wash: {}}, one: {Wash: {}}") ==
        other("8: event 7", "  recorded: ask Meal>Cook\n"
                            "  replayed: `Meal.fast` requests no task called `Cook`\n"
                            "  help: there is only `Wash`\n"
                            "  6 events before it are the same\n"));
  CHECK(replayed_with("both: {Cook: {}, Wash: {}}, one: {Wash: {}}", "all: {Cook: {}, Wash: {}}")
            .starts_with("0\nrun.jsonl: 24 events, all the same"));
  CHECK(replayed_with("external: true", "external: false") ==
        other("18: event 17", "  recorded: > set {Heat: 80}\n"
                              "  replayed: the program sets only external states, and `Heat` is not one\n"
                              "  help: `external: true` at the state declares it\n"
                              "  16 events before it are the same\n"));
  CHECK(replayed_with("stop: {sets: [Pot == 3]}, ", "") == other("23: event 22",
                                                                 "  recorded: stop Cook\n"
                                                                 "  replayed: the group `Cook` has no stop handler\n"
                                                                 "  help: `stop: true` at the group declares one\n"
                                                                 "  21 events before it are the same\n"));
}

TEST_CASE("what another group's handler would have set than the one that was called is decided otherwise") {
  World world;
  std::string both = cook;
  both.replace(both.find("  Wash: {}"), 10, "  Wash: {stop: {sets: [Pot == 1]}}");
  world.files.add("cook.yaml", both);
  world.files.add("s.yaml", "scenario: a meal\nbehaviour: cook.yaml\nscript: {Cook.stop: {set: {Pot: 3}}}\n"
                            "steps: [{request: Meal}, {cancel: Meal}]\n");
  REQUIRE(world.directorc({"simulate", "s.yaml", "--trace", "run.jsonl"}) == 0);
  std::string trace = world.outputs.files.at("run.jsonl");
  const std::size_t at = trace.find("\"assign\",\"group\":\"Cook\"");
  REQUIRE(at != std::string::npos);
  trace.replace(at, 23, "\"assign\",\"group\":\"Wash\"");
  world.files.add("run.jsonl", trace);
  CHECK(world.directorc({"replay", "run.jsonl"}) == 1);
  CHECK(world.out.find(", is decided otherwise\n  recorded: assign Pot 3\n  replayed: stop Wash\n") !=
        std::string::npos);
}

TEST_CASE("a pack whose new task a body cannot leave out is not replayed without it, and one that is optional is") {
  const std::string pack = "both: {Cook: {}, Wash: {}}", dry = "  Wash: {}\n";
  CHECK(replayed_with(pack +
                          ", one: {Wash: {}}}}\n      - {name: slow, tasks: [Cook]}\n  Cook: {stop: {sets: [Pot == "
                          "3]}, sets: [Pot <= 5]}\n" +
                          dry,
                      "both: {Cook: {}, Wash: {}, Dry: {}}, one: {Wash: {}}}}\n      - {name: slow, tasks: [Cook]}\n"
                      "  Cook: {stop: {sets: [Pot == 3]}, sets: [Pot <= 5]}\n" +
                          dry + "  Dry: {}\n") ==
        "1\nrun.jsonl:7: event 6, at 0.000000 s, cannot be replayed by `other.yaml`, another version than the one "
        "recorded\n"
        "  recorded: answer Meal.fast: pack 1 of its list\n"
        "  replayed: the pack `both` of `Meal.fast` has `Dry`, which is not optional: a body that requests the pack "
        "cannot leave it out\n"
        "  help: `optional: true` at the task declares that a body may\n"
        "  5 events before it are the same\n");
  CHECK(replayed_with(pack +
                          ", one: {Wash: {}}}}\n      - {name: slow, tasks: [Cook]}\n  Cook: {stop: {sets: [Pot == "
                          "3]}, sets: [Pot <= 5]}\n" +
                          dry,
                      "both: {Cook: {}, Wash: {}, Dry: {optional: true}}, one: {Wash: {}}}}\n      - {name: slow, "
                      "tasks: [Cook]}\n  Cook: {stop: {sets: [Pot == 3]}, sets: [Pot <= 5]}\n" +
                          dry + "  Dry: {}\n")
            .starts_with("0\nrun.jsonl: 24 events, all the same"));
}

} // namespace
