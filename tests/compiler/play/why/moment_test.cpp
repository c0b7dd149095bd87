// SPDX-License-Identifier: MIT
// Pictures of a moment of a scenario.
#include "tests/compiler/cli/world.hpp"
#include "tests/compiler/support/rover_with_key.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <ctime>

namespace {

using director::tests::check_golden;
using director::tests::rover_with_key;
using director::tests::World;

World photographer() {
  World world;
  world.files.add("rover.yaml", R"(behaviour: rover
language: 1
states:
  Motion: {values: [still, rolling], initial: still}
  Weather: {values: [dry, wet], external: true}
roots:
  Explore: {priority: 10}
  Photograph: {priority: 20}
groups:
  Explore: {tasks: [Drive]}
  Photograph: {when: [Motion == still], needs: [Wheels], tasks: [Wheels, Camera]}
  Drive:
    providers:
      - {name: rolling, needs: [Wheels], sets: [Motion == rolling], tasks: [Wheels]}
      - {name: braking, needs: [Wheels], causing: [Motion == still], tasks: [Wheels]}
  Wheels: {}
  Camera: {}
)");
  world.files.add("s.yaml", R"(scenario: a picture
behaviour: rover.yaml
script:
  Drive.rolling: {set: {Motion: rolling}, tasks: [Wheels]}
  Drive.braking:
    - {reason: wait, set: {Motion: still}, continue: true}
    - {wait: 1 s, tasks: [Wheels]}
steps:
  - request: Explore
  - request: Photograph
  - advance: 2 s
)");
  return world;
}

TEST_CASE("a picture of a moment shows what runs, what waits for what, and what is pushed", "[golden]") {
  World world = photographer();
  REQUIRE(world.directorc({"graph", "s.yaml", "--step=2"}) == 0);
  check_golden("tests/compiler/cli/commands/golden/moment.dot", world.out);
  REQUIRE(world.directorc({"graph", "s.yaml", "--step=2", "--format=mermaid"}) == 0);
  check_golden("tests/compiler/cli/commands/golden/moment.mmd", world.out);
}

TEST_CASE("a moment at a time is within the step that passes it") {
  World world = photographer();
  REQUIRE(world.directorc({"graph", "s.yaml", "--at=500 ms"}) == 0);
  const auto has = [&](const std::string& piece) { return world.out.find(piece) != std::string::npos; };
  CHECK(has("<B>rover, in step 3 (advance 2 s), at 0.5 s</B>"));
  CHECK(has(">Motion == rolling<"));
  CHECK(has(">Weather is unset<"));
  CHECK(has("pushed to"));
  REQUIRE(world.directorc({"graph", "s.yaml", "--at=1500 ms"}) == 0);
  CHECK(has("<B>rover, in step 3 (advance 2 s), at 1.5 s</B>"));
  CHECK_FALSE(has("pushed to"));
}

TEST_CASE("the need of a group that is itself only held has a blue line, from the provider for which it is held") {
  World world;
  world.files.add("leg.yaml", R"(behaviour: leg
language: 1
roots: [Walk]
groups:
  Walk: {needs: [Leg]}
  Leg: {providers: [{name: bent, needs: [Hip], tasks: [Hip]}, {name: straight, needs: [Knee], tasks: [Knee]}]}
  Hip: {needs: [Motor], tasks: [Motor]}
  Knee: {}
  Motor: {}
)");
  world.files.add("s.yaml", "behaviour: leg.yaml\nsteps: [{request: Walk}]\n");
  REQUIRE(world.directorc({"graph", "s.yaml", "--step=1", "--format=mermaid"}) == 0);
  const auto has = [&](const std::string& piece) { return world.out.find(piece) != std::string::npos; };
  CHECK(has("  g0 --o g1\n"
            "  g1p0 -->|\"needs\"| g2\n"
            "  g1p1 -->|\"needs\"| g3\n"
            "  g2 -->|\"needs\"| g4\n"));
  CHECK(has("  linkStyle 2 stroke:#8A919B\n" // of the provider that is not used
            "  linkStyle 0,1,3 stroke:#00629B\n"));
  CHECK(has("blue line: is requested or needed, and has it"));
}

TEST_CASE("the arrow of a push does not say that its task waits: it may run, and the push go on") {
  World world;
  world.files.add("rover.yaml", R"(behaviour: rover
language: 1
states: {Motion: {values: [still, rolling], initial: rolling}}
roots: {Drive: {priority: 10}, Photograph: {priority: 20}}
groups:
  Drive: {providers: [{name: rolling, sets: [Motion == rolling]}, {name: braking, causing: [Motion == still]}]}
  Photograph: {when: [Motion == still]}
)");
  world.files.add("s.yaml", R"(behaviour: rover.yaml
script: {Drive.braking: {set: {Motion: still}}}
steps: [request: Drive, request: Photograph]
)");
  REQUIRE(world.directorc({"why", "s.yaml", "Photograph"}) == 0);
  CHECK(world.out.starts_with("Photograph runs"));
  REQUIRE(world.directorc({"graph", "s.yaml", "--step=2"}) == 0);
  CHECK(world.out.find("\"Photograph has pushed Drive.braking to cause Motion == still") != std::string::npos);
}

TEST_CASE("a group that runs in the provider of its push is not pushed while the push has no effect on it") {
  World world;
  world.files.add("rover.yaml", rover_with_key);
  world.files.add("s.yaml", R"(behaviour: rover.yaml
script: {Drive: {continue: true}}
steps: [request: [Low, Photo], request: High, set: {Key: off}, cancel: High]
)");
  const auto is_pushed = [&](const char* step) {
    REQUIRE(world.directorc({"graph", "s.yaml", step}) == 0);
    const bool out = world.out.find("pushed to braking for Photo") != std::string::npos;
    CHECK((world.out.find("Photo has pushed Drive.braking") != std::string::npos) == out);
    return out;
  };
  CHECK(is_pushed("--step=1"));
  CHECK_FALSE(is_pushed("--step=2"));
  CHECK_FALSE(is_pushed("--step=3"));
  CHECK(is_pushed("--step=4"));
}

TEST_CASE(
    "of the packs of a provider only the lines of the one that is requested are marked, unless others ask alike") {
  World world;
  world.files.add("r.yaml", R"(behaviour: r
language: 1
roots: {Plan: {priority: 1}, Guard: {priority: 5}}
groups:
  Plan:
    packs:
      go: {Walk: {priority: 20}, Look: {priority: 5}}
      stroll: {Walk: {priority: 1, optional: true}}
      alike: {Walk: {priority: 1, optional: true}, Look: {}}
  Guard: {needs: [Legs], tasks: [Legs]}
  Walk: {needs: [Legs], tasks: [Legs]}
  Look: {}
  Legs: {}
)");
  world.files.add("s.yaml",
                  "behaviour: r.yaml\nscript: {Plan: {pack: stroll}}\nsteps: [request: Plan, request: Guard]\n");
  const auto colours = [&](const char* step) {
    REQUIRE(world.directorc({"graph", "s.yaml", step}) == 0);
    std::string out;
    for (const std::string line : {"go\" -> \"Walk", "stroll\" -> \"Walk", "alike\" -> \"Walk", "alike\" -> \"Look"}) {
      const std::size_t at = world.out.find("\"Plan\":\"" + line);
      REQUIRE(at != std::string::npos);
      const std::size_t colour = world.out.find("color=", at);
      out += world.out.substr(colour + 7, 7) + " ";
    }
    return out;
  };
  CHECK(colours("--step=1") == "#8A919B #00629B #00629B #8A919B ");
  CHECK(colours("--step=2") == "#8A919B #A3171A #A3171A #8A919B ");
}

TEST_CASE("frames are a file for each step") {
  World world = photographer();
  REQUIRE(world.directorc({"graph", "s.yaml", "--frames", "-o", "out", "--format=mermaid"}) == 0);
  CHECK(world.out.empty());
  CHECK(world.outputs.written == std::vector<std::string>{"out/step_1.mmd", "out/step_2.mmd", "out/step_3.mmd"});
}

TEST_CASE("frames of an earlier run that had more of them are named") {
  World world = photographer();
  REQUIRE(world.directorc({"graph", "s.yaml", "--frames", "-o", "out", "--format=mermaid"}) == 0);
  CHECK(world.err.empty());
  const std::string frame = world.outputs.files.at("out/step_3.mmd");
  for (const char* path : {"out/step_4.mmd", "out/step_12.mmd", "out/step_4.svg", "out/step_.mmd", "out/step_x.mmd",
                           "out/old/step_5.mmd", "other/step_6.mmd"}) {
    world.outputs.files[path] = frame;
    world.files.add(path, frame);
  }
  world.outputs.files["out/step_7.mmd"] = "of the user";
  world.files.add("out/step_7.mmd", "of the user");
  REQUIRE(world.directorc({"graph", "s.yaml", "--frames", "-o", "out/", "--format=mermaid"}) == 0);
  CHECK(world.err == "directorc: note: `out/` also has 2 frames of an earlier run: `step_12.mmd`, `step_4.mmd`; remove "
                     "them if you do not need them\n");
  for (const char* path : {"out/step_20.mmd", "out/step_21.mmd", "out/step_22.mmd", "out/step_23.mmd"}) {
    world.outputs.files[path] = frame;
    world.files.add(path, frame);
  }
  REQUIRE(world.directorc({"graph", "s.yaml", "--frames", "-o", "out/", "--format=mermaid"}) == 0);
  CHECK(world.err == "directorc: note: `out/` also has 6 frames of an earlier run: `step_12.mmd`, `step_20.mmd`, "
                     "`step_21.mmd`, `step_22.mmd`, `step_23.mmd` and 1 more; remove them if you do not need them\n");
}

TEST_CASE("a push that priorities forbid is not drawn; of a module, which has none, each is") {
  const auto pushes = [](const std::string& roots) {
    World world;
    world.files.add(
        "r.yaml", "behaviour: r\nlanguage: 1\nstates: {Motion: {values: [still, rolling], initial: still}}\n" + roots +
                      "groups:\n  Photograph: {when: [Motion == still]}\n  Drive:\n    providers:\n"
                      "      - {name: rolling, sets: [Motion == rolling]}\n"
                      "      - {name: braking, causing: [Motion == still]}\n");
    REQUIRE(world.directorc({"graph", "r.yaml", "--view=pushes"}) <= 1); // that there is none may be an error
    return world.out.find("\"Photograph\" -> \"Drive\":\"braking\"") != std::string::npos;
  };
  CHECK(pushes("roots: {Photograph: {priority: 20}, Drive: {priority: 10}}\n"));
  CHECK_FALSE(pushes("roots: {Photograph: {priority: 10}, Drive: {priority: 20}}\n"));
  CHECK(pushes(""));
}

TEST_CASE("a picture of a unit does not take a time of the cube of its tasks") {
  const auto time_of = [](std::size_t tasks) {
    std::string all, groups;
    for (std::size_t i = 0; i < tasks; ++i) {
      all += (i == 0 ? "T" : ", T") + std::to_string(i);
      groups += "  T" + std::to_string(i) + ": {needs: [L], tasks: [L]}\n";
    }
    World world;
    world.files.add("unit.yaml", "behaviour: unit\nlanguage: 1\nroots: [A]\ngroups:\n  A: {tasks: [" + all + "]}\n" +
                                     groups + "  L: {}\n");
    world.files.add("s.yaml", "behaviour: unit.yaml\nsteps: [request: A]\n");
    const std::clock_t begin = std::clock();
    REQUIRE(world.directorc({"graph", "s.yaml", "--step=1", "--format=json"}) <= 1); // the unit cannot be granted
    CHECK(world.out.find("cannot all be granted") != std::string::npos);
    return static_cast<double>(std::clock() - begin);
  };
  CHECK(time_of(1200) < 18 * time_of(400));
}

TEST_CASE("an unknown moment, or a file that is no scenario, is reported") {
  World world = photographer();
  const auto told = [&](const std::vector<std::string>& words) {
    return std::to_string(world.directorc(words)) + " " + world.err;
  };
  CHECK(told({"graph", "s.yaml", "--step=4"}) == "2 directorc: `s.yaml` has 3 steps\n");
  CHECK(told({"graph", "s.yaml", "--at=2 s"}) == "0 ");
  CHECK(told({"graph", "s.yaml", "--at=2000001 us"}) == "2 directorc: `s.yaml` ends at 2 s, before 2.000001 s\n");
  CHECK(told({"graph", "s.yaml", "--at=soon"}) ==
        "2 directorc: `soon` is no time: a whole number and us, ms, s or min\n");
  CHECK(told({"graph", "s.yaml", "--frames"}) ==
        "2 directorc: --frames writes many files: -o names a folder for them\n");
  CHECK(told({"graph", "s.yaml", "--step=1", "--frames", "-o", "x"}) == "2 directorc graph: --step excludes --frames\n"
                                                                        "Try `directorc graph --help`.\n");
  world.files.add("still.yaml", "behaviour: rover.yaml\n");
  CHECK(told({"graph", "still.yaml", "--frames", "-o", "x"}) ==
        "2 directorc: `still.yaml` has no steps, so there is nothing to draw after them\n");
  CHECK(told({"graph", "none.yaml", "--step=1"}).starts_with("2 directorc: "));
  CHECK(told({"graph", "rover.yaml", "--step=1"}).starts_with("1 rover.yaml:"));
}

} // namespace
