// SPDX-License-Identifier: MIT
#include "tests/compiler/cli/world.hpp"

#include <catch2/catch.hpp>

namespace {

using director::tests::World;

TEST_CASE("a wrong command line is told, with what was probably meant") {
  World world;
  CHECK(world.directorc({"chek", "x.yaml"}) == 2);
  CHECK(world.err == "directorc: there is no subcommand `chek`; did you mean `check`?\n");
  CHECK(world.directorc({"xyzzy"}) == 2);
  CHECK(world.err ==
        "directorc: there is no subcommand `xyzzy`; there are check, generate, graph, docs, diff, explain, checks, "
        "simulate, trace, replay, why, test, explore, stubs, verify, dump\n");
  CHECK(world.directorc({"check"}) == 2);
  CHECK(world.err == "directorc check: FILE is required\nTry `directorc check --help`.\n");
  CHECK(world.directorc({"check", "x.yaml", "--werror=needs_cycel"}) == 2);
  CHECK(world.err == "directorc: there is no check `needs_cycel`; did you mean `needs_cycle`?\n");
  CHECK(world.directorc({"check", "x.yaml", "--allow"}) == 2);
  CHECK(world.err == "directorc: --allow needs the id of a check, --allow=<id>\n");
  CHECK(world.directorc({}) == 2);
  CHECK(world.out.empty());
}

TEST_CASE("help and version go to the output and are no mistake") {
  World world;
  CHECK(world.directorc({"--version"}) == 0);
  CHECK(world.out.substr(0, 10) == "directorc ");
  for (const std::string word :
       {"check", "generate", "graph", "explain", "checks", "simulate", "why", "test", "stubs", "verify", "dump"}) {
    CHECK(world.directorc({word, "--help"}) == 0);
    CHECK(world.out.find("Usage: directorc " + word) != std::string::npos);
    CHECK(world.err.empty());
  }
}

TEST_CASE("a flag without a value does not take the next word") {
  World world;
  world.files.add("x.yaml", "behaviour: x\nlanguage: 1\nroots: []\n");
  CHECK(world.directorc({"check", "--werror", "--lint", "x.yaml"}) == 0);
  CHECK(world.err.empty());
}

TEST_CASE("the help ends with the first line that an editor wants, where the schemas are known") {
  const auto help = [](const std::string& schemas) {
    return std::get<director::compiler::cli::Say>(director::compiler::cli::parse({"--help"}, schemas)).text;
  };
  const std::string without = help("");
  CHECK(without.ends_with("`directorc SUBCOMMAND --help` tells more.\n"));
  CHECK(help("/usr/share/director/schemas") ==
        without + "\nAn editor with the YAML language server knows the keys where the first line is\n"
                  "# yaml-language-server: $schema=/usr/share/director/schemas/behaviour.schema.json\n"
                  "or, in a scenario,\n"
                  "# yaml-language-server: $schema=/usr/share/director/schemas/scenario.schema.json\n");
}

} // namespace
