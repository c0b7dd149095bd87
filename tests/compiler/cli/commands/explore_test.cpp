// SPDX-License-Identifier: MIT
#include "compiler/emit/artefact/notice.hpp"
#include "tests/compiler/cli/world.hpp"
#include "tests/support/command.hpp"

#include <catch2/catch.hpp>

#include <filesystem>

namespace {

using director::compiler::notice_words;
using director::tests::World;

World with(const std::string& rest) {
  World world;
  world.files.add("b.yaml", "behaviour: b\nlanguage: 1\n" + rest);
  return world;
}

const std::string two = "roots: [A, B]\ngroups: {A: {}, B: {}}\n";

TEST_CASE("an exploration reports what it saw, what it proved, and what it did not try") {
  World world = with(two + "assertions: [{can_run: A}]\n");
  CHECK(world.directorc({"explore", "b.yaml"}) == 0);
  CHECK(world.err.empty());
  CHECK(world.out.find("all there are") != std::string::npos);
  CHECK(world.out.find("  proven: can_run A: it runs after: request A\n") != std::string::npos);
  CHECK(world.out.find("Not tried\n  - a request that is kept beside one that is new\n") != std::string::npos);
  CHECK(world.outputs.files.empty());
}

TEST_CASE("a cycle that only other answers than the first ones lead into is listed as not tried") {
  World world = with("roots: [Photograph]\ngroups:\n  Photograph: {tasks: [Camera], uses: [Camera]}\n  Camera: {}\n");
  CHECK(world.directorc({"explore", "b.yaml"}) == 0); // Camera may say done each time, and be requested again
  CHECK(world.out.find("Never at rest") == std::string::npos);
  CHECK(world.out.find(
            "\n  - cycles in which a body sets a state of its `sets`, or answers otherwise than with its first pack or all "
            "its tasks\n") != std::string::npos);
}

TEST_CASE("a cycle in which the engine never comes to rest is an error, also of check, unless it takes time to keep a "
          "promise") {
  const std::string clamp = "states: {Clamp: {values: [open, shut], initial: open}}\nroots: [Charge]\ngroups:\n"
                            "  Charge: {when: [Clamp == open], needs: [Contacts], tasks: [Contacts]}\n";
  World world = with(clamp + "  Contacts: {start: {sets: [Clamp == shut]}, stop: {sets: [Clamp == open]}}\n");
  CHECK(world.directorc({"explore", "b.yaml"}) == 1);
  CHECK(world.out.find("\nNever at rest: after request Charge it repeats 3 micro-steps: Charge, Contacts\n") !=
        std::string::npos);
  CHECK(world.directorc({"check", "b.yaml"}) == 0);
  CHECK(world.directorc({"check", "--explore", "--allow=uncovered_state", "b.yaml"}) == 1);
  CHECK(world.out.substr(0, world.out.find('\n')) ==
        "b.yaml:6:3: error: the engine never comes to rest after request Charge: `Charge` and `Contacts` go round in a "
        "cycle of 3 micro-steps [never_at_rest]");
  World walk =
      with("states: {Foot: {values: [left, right], initial: left}}\nroots: [Walk]\ngroups:\n  Walk:\n    providers:\n"
           "      - {name: stepping, when: [Foot == left], causing: [Foot == right]}\n"
           "      - {name: following, causing: [Foot == left]}\n");
  CHECK(walk.directorc({"explore", "b.yaml"}) == 0);
  CHECK(walk.out.find("\nNever at rest, if what is promised takes no time: after request Walk it repeats 2 "
                      "micro-steps: Walk.following, Walk.stepping\n") != std::string::npos);
  CHECK(walk.directorc({"check", "--explore", "b.yaml"}) == 0);
}

TEST_CASE("of many sets of requested roots only some that are not explored completely are listed") {
  World world = with("roots: [A, B, C, D, E]\ngroups: {A: {}, B: {}, C: {}, D: {}, E: {}}\n");
  CHECK(world.directorc({"explore", "b.yaml", "--bound=600"}) == 3);
  const std::size_t begin = world.out.find('\n') + 1;
  CHECK(world.out.substr(begin, world.out.find("Not tried\n") - begin) == R"(  requested A: 6 found, 50.0 % explored
  requested B: 6 found, 66.7 % explored
  requested A, B: 10 found, 40.0 % explored
  requested C: 6 found, 66.7 % explored
  requested A, C: 12 found, 33.3 % explored
  requested B, C: 11 found, 45.5 % explored
  requested A, B, C: 21 found, 33.3 % explored
  requested D: 5 found, 80.0 % explored
  requested A, D: 12 found, 33.3 % explored
  requested B, D: 12 found, 41.7 % explored
  requested A, B, D: 22 found, 31.8 % explored
  requested C, D: 11 found, 45.5 % explored
  requested A, C, D: 25 found, 28.0 % explored
  requested B, C, D: 25 found, 32.0 % explored
  requested A, B, C, D: 52 found, 26.9 % explored
  requested E: 5 found, 40.0 % explored
  16 other sets of requested roots: 361 found, 15.8 % explored
)");
}

TEST_CASE("a refuted assertion is an error, and its scenario is written") {
  World world = with(two + "assertions: [{never_together: [A, B]}]\n");
  CHECK(world.directorc({"explore", "b.yaml", "--output", "found"}) == 1);
  CHECK(world.out.find("wrote found/never_together_A_B.scenario.yaml\n") != std::string::npos);
  CHECK(world.outputs.files.at("found/never_together_A_B.scenario.yaml") == "# " + notice_words("b.yaml") + R"(
scenario: "refuted: never_together [A, B]"
doc: |
  In the last step two of them are granted.
behaviour: ../b.yaml
script:
  A.default:
    - {run: 1}
  B.default:
    - {continue: true}
steps:
  - request: A
    expect: |
      run A new_task
  - request: B
    expect: |
      run B new_task
)");
}

TEST_CASE("scenarios that are written through a link name the behaviour as it is seen from their own folder") {
  namespace fs = std::filesystem;
  const director::tests::TemporaryFolder folder;
  fs::create_directories(folder.path() / "robot");
  fs::create_directories(folder.path() / "deep/er/out");
  fs::create_directory_symlink("../deep/er/out", folder.path() / "robot/found");
  const std::string file = (folder.path() / "robot/b.yaml").string(), found = (folder.path() / "robot/found").string();
  World world;
  world.files.add(file, "behaviour: b\nlanguage: 1\n" + two + "assertions: [{never_together: [A, B]}]\n");
  CHECK(world.directorc({"explore", file, "--output", found}) == 1);
  CHECK(world.outputs.files.at(found + "/never_together_A_B.scenario.yaml")
            .find("\nbehaviour: ../../../robot/b.yaml\n") != std::string::npos);
}

TEST_CASE("scenarios that would get the same name are numbered, and long names are cut") {
  std::string roots = "A, A_B, B, B_C, C", list, name = "never_together";
  for (const char digit : std::string("123456789")) {
    const std::string group = std::string(31, 'L') + digit;
    roots += ", " + group;
    list += (list.empty() ? "" : ", ") + group;
    name += "_" + group;
  }
  std::string groups;
  for (const std::string& group :
       {std::string("A"), std::string("A_B"), std::string("B"), std::string("B_C"), std::string("C")})
    groups += "  " + group + ": {}\n";
  for (const char digit : std::string("123456789")) groups += "  " + std::string(31, 'L') + digit + ": {}\n";
  World world =
      with("roots: [" + roots + "]\ngroups:\n" + groups +
           "assertions: [{never_together: [A_B, C]}, {never_together: [A, B_C]}, {never_together: [" + list + "]}]\n");
  CHECK(world.directorc({"explore", "b.yaml", "--bound", "2000", "--output", "found"}) == 1);
  std::vector<std::string> written;
  for (const auto& [path, text] : world.outputs.files) written.push_back(path);
  const std::string folder = "found/", end = ".scenario.yaml";
  CHECK(written == std::vector<std::string>{folder + "never_together_A_B_C" + end,
                                            folder + "never_together_A_B_C_2" + end,
                                            folder + name.substr(0, 200) + end});
}

TEST_CASE("a scenario of an earlier run that this one did not write is named") {
  World world = with(two + "assertions: [{never_together: [A, B]}]\n");
  const auto add = [&](const std::string& path, const std::string& text) {
    world.outputs.files[path] = text;
    world.files.add(path, text);
  };
  add("found/soft_A_B.scenario.yaml", "# " + notice_words("b.yaml") + "\nscenario: x\n");
  add("found/soft_C_D.scenario.yaml", "# " + notice_words("other.yaml") + "\nscenario: of another behaviour\n");
  add("found/mine.scenario.yaml", "scenario: of the user\n");
  CHECK(world.directorc({"explore", "b.yaml", "--output", "found"}) == 1);
  CHECK(world.err ==
        "directorc: note: `found` also has 1 scenario of an earlier run: `soft_A_B.scenario.yaml`; remove it "
        "if you do not need it\n");
  CHECK(world.outputs.files.contains("found/soft_A_B.scenario.yaml"));
}

TEST_CASE("beyond the bound it is not decided") {
  World world = with(two + "assertions: [{can_run: B}]\n");
  CHECK(world.directorc({"explore", "b.yaml", "--bound", "1"}) == 3);
  CHECK(world.out.find("  not decided: can_run B: not found in ") != std::string::npos);
}

TEST_CASE("a module cannot be explored, nor what cannot run") {
  World module = with("groups: {A: {}}\n");
  CHECK(module.directorc({"explore", "b.yaml"}) == 2);
  CHECK(module.err == "directorc: `b.yaml` has no `roots`: it is a module for others to import, and nothing can be "
                      "explored in it alone\n");
  World broken = with("roots: [A]\ngroups: {A: {needs: [B]}, B: {needs: [A]}}\n");
  CHECK(broken.directorc({"explore", "b.yaml"}) == 1);
  CHECK(broken.err.find("[needs_cycle]") != std::string::npos);
}

TEST_CASE("a check decides the assertions, and nothing is generated from what is refuted") {
  World world = with(two + "assertions: [{never_together: [A, B]}]\n");
  CHECK(world.directorc({"check", "b.yaml"}) == 1);
  CHECK(world.out.find("`never_together [A, B]` is not true: after request A; request B, two of them are granted "
                       "[assertion_failed]") != std::string::npos);
  CHECK(world.directorc({"generate", "b.yaml", "-o", "out"}) == 1);
  CHECK(world.outputs.files.empty());
}

} // namespace
