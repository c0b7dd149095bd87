#include "tests/cli/world.hpp"

#include <catch2/catch.hpp>

namespace {

using director::tests::World;

World lamp(const std::string& expect) {
  World world;
  world.files.add("lamp.yaml", "behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ngroups:\n  Lamp: {}\n");
  world.files.add("bulb.yaml", "behaviour: bulb\nlanguage: 1\ngroups:\n  Bulb: {}\n");
  world.files.add("s.yaml",
                  "scenario: it shines\nbehaviour: lamp.yaml\nsteps:\n  - request: Lamp\n    expect: " + expect + "\n");
  return world;
}

TEST_CASE("a scenario is played as text and as JSON") {
  World world = lamp("run Lamp new_task");
  CHECK(world.directorc({"simulate", "s.yaml"}) == 0);
  CHECK(world.out == "> request Lamp\nrun Lamp new_task\n");
  CHECK(world.directorc({"simulate", "--format=json", "s.yaml"}) == 0);
  CHECK(world.out == "{\"step\":1,\"event\":\"input\",\"input\":\"request Lamp\"}\n"
                     "{\"step\":1,\"event\":\"run\",\"group\":\"Lamp\",\"provider\":\"default\","
                     "\"reasons\":[\"new_task\"]}\n");
}

TEST_CASE("scenarios that hold and that do not") {
  World world = lamp("run Lamp new_task");
  CHECK(world.directorc({"test", "s.yaml", "s.yaml"}) == 0);
  CHECK(world.out == "holds s.yaml: it shines\nholds s.yaml: it shines\n2 of 2 hold\n");
  World other = lamp("run Lamp pushed");
  CHECK(other.directorc({"test", "s.yaml"}) == 1);
  CHECK(other.out.substr(0, 24) == "fails s.yaml: it shines\n");
}

TEST_CASE("a scenario that cannot be read, one whose behaviour cannot, and one of a module") {
  World world = lamp("''");
  CHECK(world.directorc({"test", "none.yaml"}) == 2);
  CHECK(world.err == "directorc: cannot read `none.yaml`: No such file or directory\n");
  world.files.add("s.yaml", "behaviour: dark.yaml\nsteps: []\n");
  CHECK(world.directorc({"simulate", "s.yaml"}) == 1);
  CHECK(world.err.find("s.yaml:1:12: error: cannot read `dark.yaml`") == 0);
  world.files.add("s.yaml", "behaviour: bulb.yaml\nsteps: []\n");
  CHECK(world.directorc({"simulate", "s.yaml"}) == 1);
  CHECK(world.err.find("s.yaml:1:12: error: `bulb.yaml` has no `roots`") == 0);
}

TEST_CASE("every stage can be printed") {
  World world = lamp("''");
  for (const std::string stage : {"spec", "model", "graph", "tables"}) {
    CHECK(world.directorc({"dump", "--stage=" + stage, "lamp.yaml"}) == 0);
    CHECK(world.out.find("Lamp") != std::string::npos);
  }
  CHECK(world.directorc({"dump", "--stage=tables", "bulb.yaml"}) == 2);
  CHECK(world.err == "directorc: `bulb.yaml` has no `roots`: a module alone has no tables\n");
}

TEST_CASE("a check is explained, and all are listed") {
  World world;
  CHECK(world.directorc({"explain", "needs_cycle"}) == 0);
  CHECK(world.out.find("Level: error") != std::string::npos);
  CHECK(world.directorc({"explain", "need_cycle"}) == 2);
  CHECK(world.err == "directorc: there is no check `need_cycle`; did you mean `needs_cycle`?\n");
  CHECK(world.directorc({"checks"}) == 0);
  CHECK(world.out.find("needs_cycle ") != std::string::npos);
}

} // namespace
