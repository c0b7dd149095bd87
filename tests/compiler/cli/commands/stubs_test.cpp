// SPDX-License-Identifier: MIT
#include "tests/compiler/cli/world.hpp"

#include <catch2/catch.hpp>

#include <filesystem>

namespace {

using director::tests::World;
namespace fs = std::filesystem;

/// A behaviour whose program has no C++ yet.
struct Beginning : World {
  Beginning() {
    files.add("cart.yaml", "behaviour: cart\nlanguage: 1\nroots: [Drive]\ngroups:\n  Drive:\n    module: wheels\n"
                           "    providers: [{name: rolling}]\n");
  }
};

TEST_CASE("stubs with a build's folder that has no compile_commands.json, or one that is wrong, writes nothing") {
  Beginning world;
  CHECK(world.directorc({"stubs", "cart.yaml", "-o", "src", "-p", "bulid"}) == 2);
  CHECK(world.err == "directorc: cannot read `bulid/compile_commands.json`: No such file or directory; CMake writes it "
                     "with -D CMAKE_EXPORT_COMPILE_COMMANDS=ON\n");
  world.files.add("bulid/compile_commands.json", "{");
  CHECK(world.directorc({"stubs", "cart.yaml", "-o", "src", "-p", "bulid"}) == 2);
  CHECK(world.err == "directorc: `bulid/compile_commands.json:1:2` is wrong: it is no JSON\n");
  CHECK(world.outputs.written.empty());
  world.files.add("bulid/compile_commands.json", "[]");
  CHECK(world.directorc({"stubs", "cart.yaml", "-o", "src", "-p", "bulid"}) == 0);
  CHECK(world.outputs.files.size() == 2);
}

TEST_CASE("stubs without a build's folder takes the nearest compile_commands.json, which may not be wrong") {
  Beginning world;
  const std::string near = (fs::current_path() / "build/compile_commands.json").string();
  world.files.add(near, "[1]");
  CHECK(world.directorc({"stubs", "cart.yaml", "-o", "src"}) == 2);
  CHECK(world.err ==
        "directorc: `" + near + "` is wrong: its entry 1 needs `directory`, `file`, and `command` or `arguments`\n");
  CHECK(world.outputs.written.empty());
}

} // namespace
