// SPDX-License-Identifier: MIT
// Names of users' files cannot control a terminal, wherever they are printed: dsl/source/harmless.hpp.
#include "dsl/source/harmless.hpp"
#include "tests/compiler/cli/world.hpp"

#include <catch2/catch.hpp>

namespace {

using director::tests::World;

constexpr const char* dark_lamp = "behaviour: lamp\nlanguage: 1\n"
                                  "states: {Power: {values: [gone, there], initial: gone, external: true}}\n"
                                  "roots: [Lamp]\ngroups: {Lamp: {tasks: [Bulb]}, Bulb: {when: [Power == there]}}\n";

/// Both streams, which must have nothing but text.
std::string told_plainly(World& world, const std::vector<std::string>& words) {
  world.directorc(words);
  CHECK(world.out.find('\x1B') == std::string::npos);
  CHECK(world.err.find('\x1B') == std::string::npos);
  return world.out + world.err;
}

TEST_CASE("what a file is called commands no terminal") {
  World world;
  const std::string file = "a\x1B[31m.yaml", other = "b\x1B[31m.yaml", scenario = "a\x1B[31m.scenario.yaml";
  world.files.add(file, dark_lamp);
  std::string changed = dark_lamp;
  changed.replace(changed.find("== there"), 8, "!= there");
  world.files.add(other, changed);
  world.files.add(scenario, "behaviour: \"a\\e[31m.yaml\"\nsteps:\n  - {request: Lamp, expect: run Lamp}\n");
  CHECK(told_plainly(world, {"check", file, "--explain-reachable", "Bulb"}).find("  a\\x1B[31m.yaml:4:9: ") !=
        std::string::npos);
  CHECK(told_plainly(world, {"check", file, "--verbose"}).find("memory and bounds of a\\x1B[31m.yaml\n") !=
        std::string::npos);
  CHECK(told_plainly(world, {"diff", file, other}).find("before a\\x1B[31m.yaml:5:") != std::string::npos);
  CHECK(told_plainly(world, {"test", scenario, "--coverage"}).find("a\\x1B[31m.scenario.yaml:3:29: step 1") !=
        std::string::npos);
  CHECK(told_plainly(world, {"why", scenario, "Bulb"}).find("(a\\x1B[31m.yaml:") != std::string::npos);
  CHECK(told_plainly(world, {"explore", file, "-o", "out\x1B[31m"}).find("[31m") == std::string::npos);
  CHECK(told_plainly(world, {"dump", file, "--stage", "model"}).find("behaviour lamp") == 0);
  CHECK(told_plainly(world, {"simulate", scenario, "--trace", "t.jsonl"}) == "> request Lamp\nrun Lamp new_task\n");
  world.files.add("t\x1B[31m.jsonl", world.outputs.files.at("t.jsonl"));
  CHECK(told_plainly(world, {"replay", "t\x1B[31m.jsonl"}).find("t\\x1B[31m.jsonl: ") == 0);
  CHECK(
      told_plainly(world, {"replay", "t\x1B[31m.jsonl", "--behaviour", "no\x1B[31m.yaml"}).find("`no\\x1B[31m.yaml`") !=
      std::string::npos);
  world.files.add(file, "doc: \"L\\e[31mamp\"\n" + std::string(dark_lamp));
  CHECK(told_plainly(world, {"graph", file, "--format=mermaid"}).find("accDescr: L [31mamp ") != std::string::npos);
  CHECK(told_plainly(world, {"graph", file}).find("digraph \"lamp\"") != std::string::npos);
  REQUIRE(world.directorc({"docs", file, "-o", "pages", "--format=markdown"}) == 0);
  CHECK(world.outputs.files.at("pages/a\x1B[31m.md").find("L \\[31mamp\n") != std::string::npos);
  CHECK(world.outputs.files.at("pages/a\x1B[31m.md").find('\x1B') == std::string::npos);
  CHECK(told_plainly(world, {"generate", "no\x1B[31m.yaml", "-o", "out"}) ==
        "directorc: cannot read `no\\x1B[31m.yaml`: No such file or directory\n");
}

TEST_CASE("what stubs would write commands no terminal, and through a pipe is as it is") {
  World world;
  world.files.add("lamp.yaml", "doc: \"L\\e[31m\tamp\"\n" + std::string(dark_lamp));
  const auto would_write = [&] {
    CHECK(world.directorc({"stubs", "lamp.yaml", "-o", "s\x1B[31m", "--dry-run"}) == 0);
    CHECK(world.err.empty());
    return world.out;
  };
  const std::string piped = would_write();
  CHECK(piped.find("+++ b/s\x1B[31m/") != std::string::npos);
  world.width = 80;
  CHECK(would_write() == director::dsl::harmless_code(piped));
}

TEST_CASE("what is wrong with a command line commands no terminal") {
  World world;
  CHECK(told_plainly(world, {"\x1B[31m"}).find("directorc: there is no subcommand `\\x1B[31m`; there are ") == 0);
  CHECK(told_plainly(world, {"check", "a.yaml", "--\x1B[31m"}) ==
        "directorc check: there is no option `--\\x1B[31m`\nTry `directorc check --help`.\n");
}

TEST_CASE("of what is very long, messages repeat the beginning and the end") {
  const std::string name(100'000, 'x'), shown = std::string(372, 'x') + "…" + std::string(125, 'x');
  World world;
  world.files.add("a.yaml", "behaviour: a\nlanguage: 1\nroots: [A]\ngroups: {A: {tasks: [" + name + "]}}\n");
  CHECK(world.directorc({"check", "a.yaml"}) == 1);
  CHECK(world.out.find("a.yaml:4:22: error: there is no group called `" + shown + "` [undefined_name]\n") == 0);
  CHECK(world.out.size() < 2000);
  CHECK(world.directorc({"check", "a.yaml", "--format=json"}) == 1);
  CHECK(world.out.find("\"message\": \"there is no group called `" + shown + "`\"") != std::string::npos);
  CHECK(world.out.find(name) == std::string::npos);
  CHECK(world.directorc({"check", "a.yaml", "--format=sarif"}) == 1);
  CHECK(world.out.find("\"text\": \"there is no group called `" + shown + "`\\nhelp: ") != std::string::npos);
  CHECK(world.out.find(name) == std::string::npos);
  CHECK(world.directorc({"check", name}) == 2);
  CHECK(world.err == "directorc: cannot read `" + shown + "`: No such file or directory\n");
}

} // namespace
