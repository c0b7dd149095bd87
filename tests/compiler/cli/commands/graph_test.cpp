// SPDX-License-Identifier: MIT
#include "compiler/emit/artefact/notice.hpp"
#include "tests/compiler/cli/world.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

namespace {

using director::compiler::notice_words;
using director::tests::check_golden;
using director::tests::World;

World walker() {
  World world;
  world.files.add("walker.yaml", R"(behaviour: walker
language: 1
layers: [skill, limb]
states: {Pose: {values: [moving, standing]}}
roots: {Walk: {priority: 1}, Kick: {priority: 2}}
groups:
  Walk:
    layer: skill
    providers:
      - {name: walking, needs: [Legs], sets: [Pose == moving], tasks: [Legs]}
      - {name: halting, needs: [Legs], causing: [Pose == standing], tasks: [Legs]}
  Kick: {layer: skill, when: [Pose == standing], needs: [Legs], tasks: {Legs: {}, Eyes: {optional: true}}}
  Legs: {layer: limb, data: "std::array<int, 2>"}
  Eyes: {layer: limb}
)");
  return world;
}

TEST_CASE("a focus shows who takes from each other what its groups can hold, also if neither is in the focus") {
  World world;
  world.files.add("cheer.yaml", R"(behaviour: cheer
language: 1
roots: {Cheer: {priority: 10}, Player: {priority: 0}}
groups:
  Cheer: {tasks: [Arm]}
  Player: {tasks: [Kick]}
  Kick: {tasks: [Arm]}
  Arm: {}
)");
  for (const char* const focus : {"--focus=Kick", "--focus=Arm"}) {
    CAPTURE(focus);
    CHECK(world.directorc({"graph", "cheer.yaml", "--view=takes", focus, "--depth=1"}) == 0);
    CHECK(world.out.find(R"("Cheer" -> "Player")") != std::string::npos);
  }
}

TEST_CASE("a group that is missing, and both needed and requested, has one arrow") {
  World world;
  world.files.add("dive.yaml", "behaviour: dive\nlanguage: 1\nroots: [Dive]\n"
                               "groups: {Dive: {needs: [Thrusters], tasks: [Thrusters]}}\n");
  CHECK(world.directorc({"graph", "--findings", "dive.yaml"}) == 1);
  const std::string arrow = R"("Dive" -> "Thrusters")";
  const std::size_t at = world.out.find(arrow);
  REQUIRE(at != std::string::npos);
  CHECK(world.out.find(arrow, at + 1) == std::string::npos);
}

TEST_CASE("the graph for Graphviz and for Mermaid, whole", "[golden]") {
  World world = walker();
  REQUIRE(world.directorc({"graph", "walker.yaml"}) == 0);
  check_golden("tests/compiler/cli/commands/golden/walker.dot", world.out);
  REQUIRE(world.directorc({"graph", "walker.yaml", "--link=https://example.org/{file}?a=1&b#L{line}"}) == 0);
  check_golden("tests/compiler/cli/commands/golden/walker_linked.dot", world.out);
  REQUIRE(world.directorc({"graph", "--format=mermaid", "walker.yaml", "--link=https://example.org/{file}#L{line}"}) ==
          0);
  check_golden("tests/compiler/cli/commands/golden/walker.mmd", world.out);
}

/// Roots that all need one group, each with a priority of its own.
std::string rivals(std::size_t count) {
  std::string roots, groups;
  for (std::size_t i = 0; i < count; ++i) {
    roots += "  T" + std::to_string(i) + ": {priority: " + std::to_string(i) + "}\n";
    groups += "  T" + std::to_string(i) + ": {needs: [Legs]}\n";
  }
  return "behaviour: many\nlanguage: 1\nroots:\n" + roots + "groups:\n  Legs: {}\n" + groups;
}

TEST_CASE("more takes than anybody can look at are not drawn, and what to do is said") {
  World world;
  world.files.add("few.yaml", rivals(63));
  world.files.add("many.yaml", rivals(64));
  CHECK(world.directorc({"graph", "few.yaml", "--view=takes"}) == 0);
  CHECK(world.directorc({"graph", "many.yaml", "--view=takes"}) == 2);
  CHECK(world.out.empty());
  CHECK(world.err ==
        "directorc: --view=takes would draw more than 2000 pairs of tasks: draw fewer groups, with --focus "
        "and --depth, or fewer boxes, with --collapse\n");
  CHECK(world.directorc({"graph", "many.yaml", "--view=takes", "--focus=T1", "--depth=1"}) == 0);
  CHECK(world.directorc({"graph", "many.yaml", "--view=takes", "--collapse=module"}) == 0);
}

TEST_CASE("unknown names for a picture are reported with the known ones") {
  World world = walker();
  const auto told = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"graph", "walker.yaml"});
    return std::to_string(world.directorc(words)) + " " + world.err;
  };
  CHECK(told({"--focus=Wlak"}) == "2 directorc: --focus: there is no group called `Wlak`; did you mean `Walk`?\n");
  CHECK(told({"--view=x"}) == "2 directorc graph: --view: x not in {all,tasks,needs,pushes,takes}\n"
                              "Try `directorc graph --help`.\n");
  CHECK(told({"--collapse=x"}) == "2 directorc graph: --collapse: x not in {module,layer}\n"
                                  "Try `directorc graph --help`.\n");
  CHECK(told({"--depth=1"}) == "2 directorc graph: --depth requires --focus\nTry `directorc graph --help`.\n");
  CHECK(told({"--link=x"}) == "2 directorc: --link needs {file} in it, and {line}: "
                              "--link='https://example.org/{file}#L{line}'\n");
  world.files.add("walker.yaml", "behaviour: walker\nlanguage: 1\ngroups: {Walk: {}}\n");
  CHECK(told({"--view=takes"}) ==
        "2 directorc: --view=takes needs a behaviour that can run: with `roots` and without errors\n");
}

TEST_CASE("a picture is drawn by the program dot, and what it answers is written") {
  World world = walker();
  REQUIRE(world.directorc({"graph", "--format=svg", "walker.yaml", "-o", "walker.svg"}) == 0);
  CHECK(world.programs.command == std::vector<std::string>{"dot", "-q", "-Tsvg"});
  CHECK(world.programs.input.substr(0, 18) == "digraph \"walker\" {");
  CHECK(world.outputs.files.at("walker.svg") == "<!-- " + notice_words("walker.yaml") + " -->\n<svg/>");
}

TEST_CASE("the file's name decides the format of a picture if none is named") {
  World world = walker();
  const auto written = [&](const std::string& file, std::vector<std::string> words = {}) {
    words.insert(words.begin(), {"graph", "walker.yaml", "-o", file});
    REQUIRE(world.directorc(words) == 0);
    return world.outputs.files.at(file).substr(0, 4);
  };
  CHECK(written("walker.svg") == "<!--");
  CHECK(written("WALKER.SVG") == "<!--");
  CHECK(written("walker.json") == "{\n  ");
  CHECK(written("walker_page.json", {"--page"}) == "{\n  ");
  CHECK(written("walker.mmd") == "%% G");
  CHECK(written("walker.dot") == "// G");
  CHECK(written("walker") == "// G");
  CHECK(written("dot.svg", {"--format=dot"}) == "// G");
  CHECK(world.directorc({"graph", "walker.yaml", "-o", "walker.png"}) == 2);
  CHECK(world.err == "directorc: `walker.png`: there is no format png; Graphviz makes it: write a dot file, with -o "
                     "walker.dot, then `dot -Tpng -o walker.png walker.dot`\n");
  CHECK_FALSE(world.outputs.files.contains("walker.png"));
  CHECK(world.directorc({"graph", "walker.yaml", "-o", "walker.html"}) == 2);
  CHECK(world.err == "directorc: `walker.html`: there is no format html; `directorc docs` writes a page\n");
  CHECK(world.directorc({"graph", "walker.yaml", "-o", "a $walker.pdf"}) == 2);
  CHECK(world.err.find("with -o 'a $walker.dot', then `dot -Tpdf -o 'a $walker.pdf' 'a $walker.dot'`") !=
        std::string::npos);
}

TEST_CASE("without Graphviz a picture is refused with what to do") {
  World world = walker();
  world.programs.answer = {};
  CHECK(world.directorc({"graph", "--format=svg", "walker.yaml"}) == 2);
  CHECK(world.err == "directorc: --format=svg needs the program `dot` of Graphviz, which is not installed (on Debian: "
                     "apt-get install graphviz); --format=dot needs nothing\n");
  world.programs.answer = {true, 3, ""};
  CHECK(world.directorc({"graph", "--format=svg", "walker.yaml"}) == 2);
  CHECK(world.err ==
        "directorc: `dot` failed with exit status 3: the graph is not drawn; --format=dot needs no Graphviz\n");
}

TEST_CASE("the list of groups of a focus ends with the word, and can be given several times") {
  World world = walker();
  REQUIRE(world.directorc({"graph", "--focus=Eyes,Walk", "walker.yaml"}) == 0);
  const std::string both = world.out;
  REQUIRE(world.directorc({"graph", "--focus", "Eyes,Walk", "walker.yaml"}) == 0);
  CHECK(world.out == both);
  REQUIRE(world.directorc({"graph", "--focus", "Eyes", "--focus", "Walk", "walker.yaml"}) == 0);
  CHECK(world.out == both);
  REQUIRE(world.directorc({"docs", "--transitions", "Walk,Kick", "walker.yaml", "-o", "p", "--format=markdown"}) == 0);
}

TEST_CASE("the graph as JSON, whole, also with a view or a focus", "[golden]") {
  World world = walker();
  REQUIRE(world.directorc({"graph", "--format=json", "walker.yaml"}) == 0);
  check_golden("tests/compiler/cli/commands/golden/walker.json", world.out);
  const std::string whole = world.out;
  REQUIRE(world.directorc({"graph", "--format=json", "walker.yaml", "--focus=Eyes", "--view=tasks"}) == 0);
  CHECK(world.out == whole);
}

} // namespace
