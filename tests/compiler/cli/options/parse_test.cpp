// SPDX-License-Identifier: MIT
#include "tests/compiler/cli/world.hpp"

#include <catch2/catch.hpp>

namespace {

using director::tests::World;

TEST_CASE("a wrong command line is reported, with a suggestion") {
  World world;
  CHECK(world.directorc({"chek", "x.yaml"}) == 2);
  CHECK(world.err == "directorc: there is no subcommand `chek`; did you mean `check`?\n");
  CHECK(world.directorc({"play", "x.scenario.yaml"}) == 2);
  CHECK(world.err == "directorc: there is no subcommand `play`; did you mean `simulate`?\n");
  CHECK(world.directorc({"help"}) == 2);
  CHECK(world.err == "directorc: there is no subcommand `help`; `directorc --help` lists them\n");
  CHECK(world.directorc({"xyzzy"}) == 2);
  CHECK(world.err ==
        "directorc: there is no subcommand `xyzzy`; there are check, generate, graph, docs, diff, explain, checks, "
        "simulate, trace, replay, why, test, explore, stubs, verify, dump\n");
  CHECK(world.directorc({"check"}) == 2);
  CHECK(world.err == "directorc check: FILE is required\nTry `directorc check --help`.\n");
  CHECK(world.directorc({"check", "x.yaml", "--werror=needs_cycel"}) == 2);
  CHECK(world.err == "directorc: there is no check `needs_cycel`; did you mean `needs_cycle`?\n");
  CHECK(world.directorc({"check", "x.yaml", "--lint=equal_priority"}) == 2);
  CHECK(world.err ==
        "directorc: `equal_priority` is no lint: it finds warnings, which are reported without `--lint`\n");
  CHECK(world.directorc({"check", "--werror", "uncovered_state", "x.yaml"}) == 2);
  CHECK(world.err == "directorc: `uncovered_state` is taken for a file: write `--werror=uncovered_state`\n");
  CHECK(world.directorc({"check", "x.yaml", "-p", "build", "--flags", "flags"}) == 2);
  CHECK(world.err == "directorc check: --build excludes --flags\nTry `directorc check --help`.\n");
  CHECK(world.directorc({"check", "x.yaml", "--verbose", "--format=sarif"}) == 2);
  CHECK(world.err ==
        "directorc: --verbose prints text or JSON, and SARIF has no place for it: leave out one of the two\n");
  CHECK(world.directorc({"check", "x.yaml", "--allow"}) == 2);
  CHECK(world.err == "directorc: --allow=ID needs the id of a check; `directorc checks` lists them\n");
  CHECK(world.directorc({}) == 2);
  CHECK(world.out.empty());
}

TEST_CASE("the first unknown option is reported, or all arguments that are too many, in their order") {
  World world;
  CHECK(world.directorc({"check", "--fromat", "json", "x.yaml", "--fro"}) == 2);
  CHECK(world.err == "directorc check: there is no option `--fromat`; did you mean `--format`?\n"
                     "Try `directorc check --help`.\n");
  CHECK(world.directorc({"check", "x.yaml", "--colours=3"}) == 2);
  CHECK(world.err == "directorc check: there is no option `--colours`\nTry `directorc check --help`.\n");
  CHECK(world.directorc({"graph", "x.yaml", "y.yaml", "z.yaml"}) == 2);
  CHECK(world.err == "directorc graph: unexpected arguments `y.yaml`, `z.yaml`\nTry `directorc graph --help`.\n");
  CHECK(world.directorc({"--versoin"}) == 2);
  CHECK(world.err == "directorc: there is no option `--versoin`; did you mean `--version`?\nTry `directorc --help`.\n");
  CHECK(world.directorc({"-x", "check", "x.yaml"}) == 2);
  CHECK(world.err == "directorc check: there is no option `-x`\nTry `directorc check --help`.\n");
  for (const std::string option : {"--werror", "--format=json", "-p"}) {
    const std::string name = option.substr(0, option.find('='));
    CHECK(world.directorc({option, "check", "w.yaml"}) == 2);
    CHECK(world.err == "directorc check: `" + name + "` is before the subcommand; write `directorc check " + name +
                           "`\nTry `directorc check --help`.\n");
  }
  CHECK(world.directorc({"check", "--verbos"}) == 2);
  CHECK(world.err == "directorc check: there is no option `--verbos`; did you mean `--verbose`?\n"
                     "Try `directorc check --help`.\n");
  CHECK(world.directorc({"graph", "--", "x.yaml", "--y.yaml"}) == 2);
  CHECK(world.err == "directorc graph: unexpected argument `--y.yaml`\nTry `directorc graph --help`.\n");
  CHECK(world.directorc({"graph", "x.yaml", "y.yaml"}) == 2);
  CHECK(world.err == "directorc graph: unexpected argument `y.yaml`\nTry `directorc graph --help`.\n");
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

TEST_CASE("the help of each subcommand has the exit statuses") {
  World world;
  for (const std::string word : {"check", "generate", "graph", "docs", "diff", "explain", "checks", "simulate", "trace",
                                 "replay", "why", "test", "explore", "stubs", "verify", "dump"}) {
    CHECK(world.directorc({word, "--help"}) == 0);
    INFO(word);
    CHECK(world.out.find("\nExit status: 0 ") != std::string::npos);
  }
}

TEST_CASE("the usage shows what is required, and what may be repeated") {
  World world;
  const auto usage = [&](const std::string& word) {
    CHECK(world.directorc({word, "--help"}) == 0);
    const std::size_t at = world.out.find("Usage: ");
    return world.out.substr(at, world.out.find('\n', at) - at);
  };
  CHECK(usage("checks") == "Usage: directorc checks [OPTIONS]");
  CHECK(usage("check") == "Usage: directorc check [OPTIONS] FILE");
  CHECK(usage("why") == "Usage: directorc why [OPTIONS] SCENARIO GROUP");
  CHECK(usage("test") == "Usage: directorc test [OPTIONS] FILE...");
  CHECK(usage("diff") == "Usage: directorc diff [OPTIONS] FILE...");
}

TEST_CASE("a file that is called - is the standard output, and a folder that is called so is refused") {
  World world;
  world.files.add("x.yaml", "behaviour: x\nlanguage: 1\nroots: [A]\ngroups: {A: {}}\n");
  world.files.add("x.scenario.yaml", "behaviour: x.yaml\nsteps: [{request: A}]\n");
  CHECK(world.directorc({"graph", "x.yaml"}) == 0);
  const std::string picture = world.out;
  CHECK(world.directorc({"graph", "x.yaml", "-o", "-"}) == 0);
  CHECK(world.out == picture);
  CHECK(world.directorc({"simulate", "x.scenario.yaml", "--trace", "t.jsonl"}) == 0);
  const std::string trace = world.outputs.files["t.jsonl"];
  world.files.add("t.jsonl", trace);
  CHECK(world.directorc({"trace", "t.jsonl", "--to=json", "-o-"}) == 0);
  CHECK(world.out == trace);
  world.outputs.written.clear();
  const auto refused = [&](const std::vector<std::string>& words) {
    CHECK(world.directorc(words) == 2);
    CHECK(world.out.empty());
    return world.err;
  };
  const std::string no_folder =
      "directorc: -o names a folder, and `-` is the standard output: a folder called so is `./-`\n";
  CHECK(refused({"generate", "x.yaml", "-o", "-"}) == no_folder);
  CHECK(refused({"docs", "x.yaml", "-o", "-"}) == no_folder);
  CHECK(refused({"stubs", "x.yaml", "-o", "-"}) == no_folder);
  CHECK(refused({"explore", "x.yaml", "-o", "-"}) == no_folder);
  CHECK(refused({"graph", "x.scenario.yaml", "--frames", "-o", "-"}) == no_folder);
  CHECK(refused({"simulate", "x.scenario.yaml", "--trace", "-"}) ==
        "directorc: --trace names a file, and `-` is the standard output: a file called so is `./-`\n");
  CHECK(refused({"generate", "x.yaml", "-o", "out", "--depfile", "-"}) ==
        "directorc: --depfile names a file, and `-` is the standard output: a file called so is `./-`\n");
  CHECK(world.outputs.written.empty());
}

TEST_CASE("an empty value is reported") {
  World world;
  world.files.add("x.yaml", "behaviour: x\nlanguage: 1\nroots: []\n");
  const auto told = [&](const std::vector<std::string>& words) {
    CHECK(world.directorc(words) == 2);
    CHECK(world.out.empty());
    return world.err;
  };
  CHECK(told({"check", "x.yaml", "-p", ""}) == "directorc check: --build is empty\nTry `directorc check --help`.\n");
  CHECK(told({"check", ""}) == "directorc check: FILE is empty\nTry `directorc check --help`.\n");
  CHECK(told({"test", "a", ""}) == "directorc test: FILE is empty\nTry `directorc test --help`.\n");
  CHECK(told({"check", "x.yaml", "--explain-reachable", ""}) ==
        "directorc check: --explain-reachable is empty\nTry `directorc check --help`.\n");
  CHECK(told({"check", "--build=", "x.yaml"}) == "directorc check: --build is empty\nTry `directorc check --help`.\n");
  CHECK(told({"diff", "--breaking=", "x.yaml", "x.yaml"}) ==
        "directorc diff: --breaking is empty\nTry `directorc diff --help`.\n");
  CHECK(told({"graph", "--focus=", "x.yaml"}) == "directorc graph: --focus is empty\nTry `directorc graph --help`.\n");
  CHECK(told({"check", "--allow=", "x.yaml"}) == "directorc check: --allow is empty\nTry `directorc check --help`.\n");
  CHECK(told({"check", "--biuld=", "x.yaml"}) ==
        "directorc check: there is no option `--biuld`; did you mean `--build`?\nTry `directorc check --help`.\n");
}

TEST_CASE("a flag without a value does not take the next argument") {
  World world;
  world.files.add("x.yaml", "behaviour: x\nlanguage: 1\nroots: []\n");
  CHECK(world.directorc({"check", "--werror", "--lint", "x.yaml"}) == 0);
  CHECK(world.err.empty());
}

TEST_CASE("the help ends with the first line that an editor wants, where the schemas are known") {
  const auto help = [](const std::string& schemas) {
    return std::get<director::compiler::cli::Message>(director::compiler::cli::parse({"--help"}, schemas)).text;
  };
  const std::string without = help("");
  CHECK(without.ends_with("`directorc SUBCOMMAND --help` lists its options.\n"));
  CHECK(help("/usr/share/director/schemas") ==
        without + "\nAn editor with the YAML language server knows the keys where the first line is\n"
                  "# yaml-language-server: $schema=/usr/share/director/schemas/behaviour.schema.json\n"
                  "or, in a scenario,\n"
                  "# yaml-language-server: $schema=/usr/share/director/schemas/scenario.schema.json\n"
                  "The same folder has the schemas of what `graph` and `diff` print as JSON, and of traces.\n");
}

} // namespace
