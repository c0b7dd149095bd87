// SPDX-License-Identifier: MIT
#include "compiler/emit/artefact/notice.hpp"
#include "tests/compiler/cli/world.hpp"

#include <catch2/catch.hpp>

namespace {

using director::compiler::notice_words;
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

TEST_CASE("the graph for Graphviz has its layers as ranks, an arrow of each kind and a legend") {
  World world = walker();
  REQUIRE(world.directorc({"graph", "walker.yaml"}) == 0);
  const auto has = [&](const std::string& piece) { return world.out.find(piece) != std::string::npos; };
  CHECK(has("newrank=true"));
  CHECK(has("{rank=same; layer0; g0; g1;}"));
  CHECK(has("{rank=same; layer1; g2; g3;}"));
  CHECK(has("layer0 -> layer1 [style=invis, weight=100]"));
  CHECK(has("g0 -> g2 [color=\"#404040:#0072B2\", arrowhead=vee]"));
  CHECK(has("g1 -> g3 [color=\"#404040\", style=dotted, arrowhead=vee]"));
  CHECK(has("g0:p1 -> g1 [color=\"#00805A\", style=dashed, arrowhead=empty, constraint=false, "
            "tooltip=\"Pose == standing\"]"));
  CHECK(has("may request (task)"));
  CHECK(has("std::array&lt;int, 2&gt;"));
}

TEST_CASE("a picture is drawn by the program dot, and what it answers is written") {
  World world = walker();
  REQUIRE(world.directorc({"graph", "--format=svg", "walker.yaml", "-o", "walker.svg"}) == 0);
  CHECK(world.programs.command == std::vector<std::string>{"dot", "-Tsvg"});
  CHECK(world.programs.input.substr(0, 18) == "digraph \"walker\" {");
  CHECK(world.outputs.files.at("walker.svg") == "<!-- " + notice_words("walker.yaml") + " -->\n<svg/>");
}

TEST_CASE("without Graphviz a picture is refused with what to do") {
  World world = walker();
  world.programs.answer = {};
  CHECK(world.directorc({"graph", "--format=svg", "walker.yaml"}) == 2);
  CHECK(world.err == "directorc: --format=svg needs the program `dot` of Graphviz, which is not installed (on Debian: "
                     "apt-get install graphviz); --format=dot needs nothing\n");
  world.programs.answer = {true, 3, ""};
  CHECK(world.directorc({"graph", "--format=svg", "walker.yaml"}) == 2);
  CHECK(world.err == "directorc: `dot` could not draw the graph (exit status 3)\n");
}

TEST_CASE("the graph as JSON and as Mermaid") {
  World world = walker();
  REQUIRE(world.directorc({"graph", "--format=json", "walker.yaml"}) == 0);
  CHECK(world.out.find("\"causer\": \"Walk.halting\"") != std::string::npos);
  REQUIRE(world.directorc({"graph", "--format=mermaid", "walker.yaml"}) == 0);
  CHECK(world.out.find("p1 -. \"Pose == standing\" .-> g1") != std::string::npos);
}

} // namespace
