// SPDX-License-Identifier: MIT
#include "tests/compiler/cli/world.hpp"

#include <catch2/catch.hpp>

namespace {

using director::tests::World;
using Paths = std::vector<std::string>;

const std::string lamp_text = "behaviour: lamp\nlanguage: 1\nimports: [parts/my bulb.yaml]\nroots: [Lamp]\n"
                              "groups:\n  Lamp: {tasks: [Bulb]}\n";
const std::string bulb = "behaviour: bulb\nlanguage: 1\ngroups:\n  Bulb: {}\n";

World lit() {
  World world;
  world.files.add("lamp.yaml", lamp_text);
  world.files.add("parts/my bulb.yaml", bulb);
  return world;
}

TEST_CASE("header, facts, source, manifest and what they depend on are written, the header last") {
  World world = lit();
  CHECK(world.directorc({"generate", "lamp.yaml", "-o", "out", "--depfile", "out/lamp.d"}) == 0);
  // An interruption between two of them leaves an old header, which `verify` and a build report.
  CHECK(world.outputs.written ==
        Paths{"out/lamp.facts.hpp", "out/lamp.cpp", "out/manifest.json", "out/lamp.d", "out/lamp.hpp"});
  CHECK(world.outputs.files.at("out/lamp.d") ==
        "out/lamp.hpp out/lamp.facts.hpp out/lamp.cpp out/manifest.json: \\\n  lamp.yaml \\\n  parts/my\\ bulb.yaml\n");
  CHECK(world.out.empty());
  CHECK(world.err.empty());
}

TEST_CASE("a build that looks at a stamp of its own names it in the depfile") {
  World world = lit();
  CHECK(world.directorc({"generate", "lamp.yaml", "-o", "out", "--depfile", "lamp.d", "--depfile-target", "stamp"}) ==
        0);
  CHECK(world.outputs.files.at("lamp.d") == "stamp: \\\n  lamp.yaml \\\n  parts/my\\ bulb.yaml\n");
}

TEST_CASE("what has not changed is not written again") {
  World world = lit();
  world.directorc({"generate", "lamp.yaml", "-o", "out"});
  world.outputs.written.clear();
  CHECK(world.directorc({"generate", "lamp.yaml", "-o", "out"}) == 0);
  CHECK(world.outputs.written.empty());
}

TEST_CASE("equal input gives equal bytes, in any folder") {
  World here = lit(), there;
  there.files.add("far/away/lamp.yaml", lamp_text);
  there.files.add("far/away/parts/my bulb.yaml", bulb);
  here.directorc({"generate", "lamp.yaml", "-o", "out"});
  there.directorc({"generate", "far/away/lamp.yaml", "-o", "out"});
  CHECK(here.outputs.files == there.outputs.files);
}

TEST_CASE("a module has nothing to generate") {
  World world = lit();
  CHECK(world.directorc({"generate", "parts/my bulb.yaml", "-o", "out"}) == 2);
  CHECK(world.err == "directorc: `parts/my bulb.yaml` has no `roots`: it is a module for others to import, and nothing "
                     "can be generated from it alone\n");
  CHECK(world.outputs.written.empty());
}

TEST_CASE("errors are reported, and nothing is written") {
  World world = lit();
  world.files.add("lamp.yaml", lamp_text + "extern: [Shade]\n");
  CHECK(world.directorc({"generate", "lamp.yaml", "-o", "out"}) == 1);
  CHECK(world.err.find("[unprovided_task]") != std::string::npos);
  CHECK(world.outputs.written.empty());
}

} // namespace
