// SPDX-License-Identifier: MIT
// Pictures of behaviours with mistakes.
#include "tests/compiler/cli/world.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

namespace {

using director::tests::check_golden;
using director::tests::World;

World with_mistakes() {
  World world;
  world.files.add("rover.yaml", R"(behaviour: rover
language: 1
states:
  Motion: {values: [still, rolling], initial: still}
roots: {Explore: {priority: 10}, Photograph: {priority: 20}, Dance: {}}
groups:
  Explore: {tasks: [Drive, Sing]}
  Photograph: {when: [Motion == stil], needs: [Wheels], tasks: [Wheels]}
  Drive:
    providers:
      - {name: rolling, needs: [Wheels, Motor], tasks: [Wheels]}
      - {name: braking, needs: [Wheels], causing: [Motion == still], packs: {on: {Sing: {}}, off: {Wheels: {}}}}
  Wheels: {}
)");
  return world;
}

TEST_CASE("a behaviour with mistakes is drawn as far as it goes, and what is missing in red", "[golden]") {
  World world = with_mistakes();
  CHECK(world.directorc({"graph", "rover.yaml"}) == 1);
  CHECK(world.err.find("error: there is no group called `Sing`") != std::string::npos);
  check_golden("tests/compiler/cli/commands/golden/mistakes.dot", world.out);
}

TEST_CASE("findings are in the box and the row that they are about, others below the picture", "[golden]") {
  World world = with_mistakes();
  CHECK(world.directorc({"graph", "rover.yaml", "--findings"}) == 1);
  check_golden("tests/compiler/cli/commands/golden/mistakes_findings.dot", world.out);
}

TEST_CASE("warnings are drawn where they are requested, and are no failure") {
  World world;
  world.files.add("lamp.yaml",
                  "behaviour: lamp\nlanguage: 1\nroots: [Lamp, Torch]\ngroups:\n"
                  "  Lamp: {needs: [Plug], tasks: [Plug]}\n  Torch: {needs: [Plug], tasks: [Plug]}\n  Plug: {}\n");
  CHECK(world.directorc({"graph", "lamp.yaml"}) == 0);
  CHECK(world.out.find("equal_priority") == std::string::npos);
  CHECK(world.directorc({"graph", "lamp.yaml", "--findings"}) == 0);
  CHECK(world.err.empty());
  CHECK(world.out.find("equal_priority") != std::string::npos);
}

TEST_CASE("what cannot be read has no picture") {
  World world;
  world.files.add("broken.yaml", "behaviour: [\n");
  CHECK(world.directorc({"graph", "broken.yaml"}) == 1);
  CHECK(world.out.empty());
}

TEST_CASE("what a module requests of others is drawn too") {
  World world;
  world.files.add("module.yaml",
                  "behaviour: part\nlanguage: 1\nextern: [Legs]\ngroups: {Walk: {needs: [Legs], tasks: [Legs]}}\n");
  CHECK(world.directorc({"graph", "module.yaml"}) == 0);
  CHECK(world.out.find("\"Walk\" -> \"Legs\"") != std::string::npos);
}

} // namespace
