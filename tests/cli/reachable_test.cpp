#include "tests/cli/world.hpp"

#include <catch2/catch.hpp>

namespace {

using director::tests::World;

World lamp() {
  World world;
  world.files.add("lamp.yaml", "behaviour: lamp\nlanguage: 1\nstates: {Day: {values: [no, yes], initial: no}}\n"
                               "roots: [Lamp]\ngroups:\n  Lamp: {sets: [Day == yes]}\n  Bell: {}\n");
  world.files.add("bulb.yaml", "behaviour: bulb\nlanguage: 1\ngroups:\n  Bulb: {}\n");
  return world;
}

TEST_CASE("how something may be reached is told behind the findings") {
  World world = lamp();
  CHECK(world.directorc({"check", "lamp.yaml", "--explain-reachable", "Day == yes", "--allow=yaml_word_trap"}) == 0);
  CHECK(world.out == "`Day == yes` may be reached:\n"
                     "  lamp.yaml:4:9: the program may request `Lamp`\n"
                     "  lamp.yaml:6:3: `Lamp` may run\n"
                     "  lamp.yaml:6:17: `Lamp` may set `Day == yes`\n");
  CHECK(world.directorc({"check", "lamp.yaml", "--explain-reachable=Bell", "--allow=yaml_word_trap"}) == 1);
  CHECK(world.out == "`Bell` can never be reached:\n"
                     "  lamp.yaml:7:3: nothing requests `Bell`\n");
}

TEST_CASE("what is missing is told to the bottom") {
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
                           "  door.yaml:8:3: nothing requests `Seek`\n";
  CHECK(world.out.ends_with("`Enter` can never be reached:\n" + told));
  CHECK(world.directorc({"check", "door.yaml", "--explain-reachable=Door == open"}) == 1);
  CHECK(world.out.ends_with("`Door == open` can never be reached:\n" + told.substr(told.find('\n') + 1)));
  CHECK(world.directorc({"check", "door.yaml", "--explain-reachable=Key == found", "--format=json"}) == 1);
  CHECK(world.out.ends_with(R"(  "reachable": {
    "of": "Key == found",
    "reachable": false,
    "steps": [],
    "missing": []
  }
}
)"));
}

TEST_CASE("what it may be asked about") {
  World world = lamp();
  CHECK(world.directorc({"check", "lamp.yaml", "--explain-reachable=Lump"}) == 2);
  CHECK(world.err == "directorc: there is no group called `Lump`; did you mean `Lamp`?\n");
  CHECK(world.directorc({"check", "lamp.yaml", "--explain-reachable=Lamp.dim"}) == 2);
  CHECK(world.err == "directorc: the group `Lamp` has no provider called `dim`\n");
  CHECK(world.directorc({"check", "lamp.yaml", "--explain-reachable=Day == often"}) == 2);
  CHECK(world.err == "directorc: `often` is no value of the state `Day`: its values are no, yes\n");
  CHECK(world.directorc({"check", "bulb.yaml", "--explain-reachable=Bulb"}) == 2);
  CHECK(world.err ==
        "directorc: `bulb.yaml` has no `roots`: what can be reached in a module depends on who imports it\n");
}

TEST_CASE("the same as JSON") {
  World world = lamp();
  CHECK(world.directorc({"check", "--format=json", "lamp.yaml", "--explain-reachable=Lamp.default",
                         "--allow=yaml_word_trap"}) == 0);
  CHECK(world.out == R"({
  "findings": [],
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
