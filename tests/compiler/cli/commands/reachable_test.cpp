// SPDX-License-Identifier: MIT
#include "tests/compiler/cli/world.hpp"

#include <catch2/catch.hpp>

namespace {

using director::tests::World;

World lamp_and_bell() {
  World world;
  world.files.add("lamp.yaml", "behaviour: lamp\nlanguage: 1\nstates: {Day: {values: [no, yes], initial: no}}\n"
                               "roots: [Lamp]\ngroups:\n  Lamp: {sets: [Day == yes]}\n  Bell: {}\n");
  world.files.add("bulb.yaml", "behaviour: bulb\nlanguage: 1\ngroups:\n  Bulb: {}\n");
  return world;
}

TEST_CASE("the way to something reachable is printed behind the findings") {
  World world = lamp_and_bell();
  CHECK(world.directorc({"check", "lamp.yaml", "--explain-reachable", "Day == yes", "--allow=yaml_word_trap"}) == 0);
  CHECK(world.out == "`Day == yes` may be reached:\n"
                     "  lamp.yaml:4:9: the program may request `Lamp`\n"
                     "  lamp.yaml:6:3: `Lamp` may run\n"
                     "  lamp.yaml:6:17: `Lamp` may set `Day == yes`\n");
  CHECK(world.directorc({"check", "lamp.yaml", "--explain-reachable=Bell", "--allow=yaml_word_trap"}) == 1);
  CHECK(world.out == "`Bell` can never be reached:\n"
                     "  lamp.yaml:7:3: nothing requests `Bell`\n");
}

TEST_CASE("of conditions that exclude each other it is said that they do") {
  World world;
  world.files.add("door.yaml", R"(behaviour: door
language: 1
states: {Door: {values: [shut, open], initial: shut, external: true}}
roots: [Enter]
groups:
  Enter: {when: [Door == shut, Door == open]}
)");
  CHECK(world.directorc({"check", "door.yaml", "--explain-reachable=Enter"}) == 1);
  CHECK(world.out.ends_with("`Enter` can never be reached:\n"
                            "  door.yaml:6:32: `Door == shut` and `Door == open` never hold together\n"));
}

TEST_CASE("what is missing is reported down to the cause") {
  World world;
  world.files.add("door.yaml", R"(behaviour: door
language: 1
states: {Door: {values: [shut, open], initial: shut}, Key: {values: [lost, found, turned], initial: lost}}
roots: {Enter: {priority: 20}, Open: {priority: 10}}
groups:
  Enter: {when: [Door == open]}
  Open: {when: [Key == turned], causing: [Door == open]}
  Seek: {tasks: [Turn]}
  Turn: {when: [Key == found], sets: [Key == turned]}
)");
  CHECK(world.directorc({"check", "door.yaml", "--explain-reachable=Enter"}) == 1);
  const std::string told = "  door.yaml:6:18: it waits for `Door == open`, and only `Open` could set that\n"
                           "  door.yaml:7:17: it waits for `Key == turned`, and only `Turn` could set that\n"
                           "  door.yaml:8:18: `Seek` requests `Turn`, but never runs itself\n"
                           "  door.yaml:8:3: nothing requests `Seek`\n"
                           "  door.yaml:9:17: it waits for `Key == found`, and nothing sets that\n";
  CHECK(world.out.ends_with("`Enter` can never be reached:\n" + told));
  CHECK(world.directorc({"check", "door.yaml", "--explain-reachable=Door == open"}) == 1);
  CHECK(world.out.ends_with("`Door == open` can never be reached:\n" + told.substr(told.find('\n') + 1)));
  CHECK(world.directorc({"check", "door.yaml", "--explain-reachable=Key == found", "--format=json"}) == 1);
  CHECK(world.out.ends_with(R"(  "reachable": {
    "of": "Key == found",
    "reachable": false,
    "steps": [],
    "missing": [
      {
        "file": "door.yaml",
        "line": 3,
        "column": 55,
        "end_line": 3,
        "end_column": 58,
        "message": "nothing causes or sets `Key == found`"
      }
    ]
  }
}
)"));
}

TEST_CASE("the goals that it accepts") {
  World world = lamp_and_bell();
  CHECK(world.directorc({"check", "lamp.yaml", "--explain-reachable=Lump"}) == 2);
  CHECK(world.err == "directorc: there is no group called `Lump`; did you mean `Lamp`?\n");
  CHECK(world.directorc({"check", "lamp.yaml", "--explain-reachable=Lamp.dim"}) == 2);
  CHECK(world.err == "directorc: the group `Lamp` has no provider called `dim`; there is only `default`\n");
  CHECK(world.directorc({"check", "lamp.yaml", "--explain-reachable=Day == often"}) == 2);
  CHECK(world.err ==
        "directorc: `often` is no value of the state `Day`: its values are no, yes; write one of them, or add it to "
        "the `values`\n");
  CHECK(world.directorc({"check", "bulb.yaml", "--explain-reachable=Bulb"}) == 2);
  CHECK(world.err == "directorc: `bulb.yaml` has no `roots`: what can be reached in a module depends on the deployment "
                     "that imports it\n");
}

TEST_CASE("a wrong condition is reported as in a behaviour") {
  World world = lamp_and_bell();
  const auto refused = [&](const std::string& words) {
    CHECK(world.directorc({"check", "lamp.yaml", "--explain-reachable=" + words}) == 2);
    return world.err;
  };
  CHECK(refused("Day = yes") ==
        "directorc: expected one of ==, !=, <, <=, >, >= behind `Day`, found `=`; write `==`\n");
  CHECK(refused("Day == ") == "directorc: expected a value behind `==`, found nothing\n");
  CHECK(refused("Day == yes && Lamp") ==
        "directorc: expected the end of the condition, found `&&`; each condition is an "
        "entry of its own in the list; all must hold\n");
  CHECK(refused("Dya == yes") == "directorc: there is no state called `Dya`; did you mean `Day`?\n");
  CHECK(refused("Day == ye") ==
        "directorc: `ye` is no value of the state `Day`: its values are no, yes; did you mean `yes`?\n");
  CHECK(refused("Day != no") ==
        "directorc: expected one value of a state, found `Day != no`; for example `Day == yes`\n");
  CHECK(refused("Day == no|yes") ==
        "directorc: expected one value of a state, found `Day == no|yes`; for example `Day == yes`\n");
  CHECK(refused("Day") == "directorc: `Day` is a state; name one of its values: `Day == yes`\n");
}

TEST_CASE("SARIF too has what is missing") {
  World world = lamp_and_bell();
  CHECK(world.directorc({"check", "--format=sarif", "lamp.yaml", "--explain-reachable=Lamp"}) == 0);
  CHECK(world.out.find("\"text\": \"`Lamp` may be reached:\"") != std::string::npos);
  CHECK(world.directorc({"check", "--format=sarif", "lamp.yaml", "--explain-reachable=Bell"}) == 1);
  CHECK(world.out.find("\"text\": \"`Bell` can never be reached:\"") != std::string::npos);
}

TEST_CASE("the same as JSON") {
  World world = lamp_and_bell();
  CHECK(world.directorc({"check", "--format=json", "lamp.yaml", "--explain-reachable=Lamp.default",
                         "--allow=yaml_word_trap"}) == 0);
  CHECK(world.out == R"({
  "findings": [],
  "not_decided": [],
  "reachable": {
    "of": "Lamp.default",
    "reachable": true,
    "steps": [
      {
        "file": "lamp.yaml",
        "line": 4,
        "column": 9,
        "end_line": 4,
        "end_column": 13,
        "message": "the program may request `Lamp`"
      },
      {
        "file": "lamp.yaml",
        "line": 6,
        "column": 3,
        "end_line": 6,
        "end_column": 7,
        "message": "`Lamp` may run"
      }
    ]
  }
}
)");
}

} // namespace
