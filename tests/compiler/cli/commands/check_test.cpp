// SPDX-License-Identifier: MIT
#include "tests/compiler/cli/world.hpp"
#include "tests/support/environment.hpp"

#include <catch2/catch.hpp>

namespace {

using director::tests::World;

const std::string misspelt = "behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ngroups:\n  Lamp: {nedes: []}\n";

TEST_CASE("findings are reported with their place, and errors make the exit status") {
  World world;
  world.files.add("lamp.yaml", misspelt);
  CHECK(world.directorc({"check", "lamp.yaml"}) == 1);
  CHECK(world.out.substr(0, 23) == "lamp.yaml:5:10: error: ");
  CHECK(world.out.find("[unknown_key]") != std::string::npos);
  CHECK(world.err.empty());
}

TEST_CASE("a file that is not there is no finding") {
  World world;
  CHECK(world.directorc({"check", "lamp.yaml"}) == 2);
  CHECK(world.out.empty());
  CHECK(world.err == "directorc: cannot read `lamp.yaml`: No such file or directory\n");
}

TEST_CASE("a build or flags that cannot be read are reported, also if no type is requested") {
  World world;
  world.files.add("lamp.yaml", "behaviour: lamp\nlanguage: 1\nroots: []\n");
  CHECK(world.directorc({"check", "-p", "bulid", "lamp.yaml"}) == 2);
  CHECK(world.out.empty());
  CHECK(world.err == "directorc: cannot read `bulid/compile_commands.json`: No such file or directory; CMake writes it "
                     "with -D CMAKE_EXPORT_COMPILE_COMMANDS=ON\n");
  CHECK(world.directorc({"generate", "lamp.yaml", "-o", "out", "--flags", "lamp.flags"}) == 2);
  CHECK(world.err == "directorc: cannot read `lamp.flags`: No such file or directory\n");
  CHECK(world.outputs.files.empty());
  world.files.add("build/compile_commands.json", "{");
  CHECK(world.directorc({"check", "-p", "build", "lamp.yaml"}) == 0); // the file is not read
  world.files.add("lamp.yaml", "behaviour: lamp\nlanguage: 1\ncpp: {headers: [a.hpp]}\nroots: [Lamp]\n"
                               "groups: {Lamp: {data: Level}}\n");
  CHECK(world.directorc({"check", "-p", "build", "lamp.yaml"}) == 2);
  CHECK(world.err == "directorc: `build/compile_commands.json:1:2` is wrong: it is no JSON\n");
}

TEST_CASE("types that -p should have checked and that cannot be read are reported, where no finding says it") {
  World world;
  const std::string head = "behaviour: lamp\nlanguage: 1\ncpp: {headers: [types.hpp]}\nroots: [Lamp]\n";
  world.files.add("lamp.yaml", head + "groups: {Lamp: {data: Nowhere}}\n");
  world.files.add("build/compile_commands.json", "[]");
  const std::string told = "directorc: types of C++ are not checked: `build/compile_commands.json` compiles no C++\n";
  CHECK(world.directorc({"check", "-p", "build", "lamp.yaml"}) == 0);
  CHECK(world.out.empty());
  CHECK(world.err == told);
  CHECK(world.directorc({"generate", "-p", "build", "-o", "out", "lamp.yaml"}) == 0);
  CHECK(world.err == told);
  world.files.add("flags", "g++\n");
  CHECK(world.directorc({"check", "--flags", "flags", "lamp.yaml"}) == 0);
  CHECK(world.err.empty());
  world.files.add("mode.yaml",
                  head + "states: {Mode: {type: Mode, external: true}}\ngroups: {Lamp: {when: [Mode == a]}}\n");
  CHECK(world.directorc({"check", "-p", "build", "mode.yaml"}) == 1);
  CHECK(world.out.find("compiles no C++ [type_needs_scanner]") != std::string::npos);
  CHECK(world.err.empty());
}

TEST_CASE("an import that is not there is a finding") {
  World world;
  world.files.add("lamp.yaml", "behaviour: lamp\nlanguage: 1\nimports: [bulb.yaml]\nroots: []\n");
  CHECK(world.directorc({"check", "lamp.yaml"}) == 1);
  CHECK(world.out.find("[import_not_found]") != std::string::npos);
}

TEST_CASE("findings as JSON have lines and columns from 1 and exclusive ends") {
  World world;
  world.files.add("lamp.yaml", misspelt);
  CHECK(world.directorc({"check", "--format=json", "lamp.yaml"}) == 1);
  const std::string begin = "{\n  \"findings\": [\n    {\n      \"id\": \"unknown_key\",\n      \"level\": \"error\",\n"
                            "      \"file\": \"lamp.yaml\",\n      \"line\": 5,\n      \"column\": 10,\n"
                            "      \"end_line\": 5,\n      \"end_column\": 15,\n      \"message\": ";
  CHECK(world.out.substr(0, begin.size()) == begin);
  world.files.add("lamp.yaml", "behaviour: lamp\nlanguage: 1\nroots: []\n");
  CHECK(world.directorc({"check", "--format=json", "lamp.yaml"}) == 0);
  CHECK(world.out == "{\n  \"findings\": [],\n  \"not_decided\": []\n}\n");
}

TEST_CASE("warnings become errors on request, are not reported if allowed, and lints are reported on request") {
  World world;
  world.files.add("lamp.yaml", "behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ntriggers: [Bell]\ngroups:\n"
                               "  Lamp: {allow: [useless_use], because: to try it}\n");
  CHECK(world.directorc({"check", "lamp.yaml"}) == 0);
  CHECK(world.out.find("warning: ") != std::string::npos);
  CHECK(world.out.find("[unused_allow]") != std::string::npos);
  CHECK(world.out.find("[unused_declaration]") == std::string::npos);
  CHECK(world.directorc({"check", "lamp.yaml", "--werror"}) == 1);
  CHECK(world.directorc({"check", "lamp.yaml", "--werror=unused_allow"}) == 1);
  CHECK(world.directorc({"check", "lamp.yaml", "--werror=needs_cycle"}) == 0);
  CHECK(world.directorc({"check", "lamp.yaml", "--werror", "--allow=unused_allow"}) == 0);
  CHECK(world.out.empty());
  CHECK(world.directorc({"check", "lamp.yaml", "--lint=unused_declaration"}) == 0);
  CHECK(world.directorc({"check", "lamp.yaml", "--werror=unused_declaration"}) == 1);
  CHECK(world.out.find("[unused_declaration]") != std::string::npos);
}

TEST_CASE("an error is reported, even with --allow") {
  World world;
  world.files.add("lamp.yaml", misspelt);
  CHECK(world.directorc({"check", "lamp.yaml", "--allow=unknown_key"}) == 1);
}

TEST_CASE("what is not decided within the bound is reported, and nothing is generated") {
  if (director::tests::is_sanitized) return; // giving up takes as long as trying everything up to the bound
  std::string states = "states:\n", roots = "roots: {Boss: {priority: 99}", groups;
  for (int i = 0; i < 16; ++i) {
    const std::string n = std::to_string(i);
    states += "  S" + n + ": {values: [low, high], initial: low, external: true}\n";
    roots += ", A" + n + ": {priority: " + n + "}";
    groups += "  A" + n + ": {when: [S" + n + " == high]}\n";
  }
  World world;
  world.files.add("lamp.yaml",
                  "behaviour: lamp\nlanguage: 1\n" + states + roots + "}\ngroups:\n" + groups +
                      "  Boss: {needs: [Lamp], packs: {go: {Lit: {}}}}\n  Lit: {needs: [Lamp]}\n  Lamp: {}\n"
                      "assertions: [{can_run: Lit}]\nallow: [uncovered_state, self_conflict]\nbecause: to try it\n");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"check", "lamp.yaml"}, {"generate", "lamp.yaml", "-o", "out"}}) {
    CHECK(world.directorc(words) == 3);
    CHECK(world.out.empty());
    CHECK(world.err.find("directorc: not decided: can_run Lit: not found in ") == 0);
  }
  CHECK(world.outputs.written.empty());
}

TEST_CASE("an assertion that needs more states than usual is decided with `--bound`, and then it is generated") {
  World world;
  world.files.add("lamp.yaml",
                  "behaviour: lamp\nlanguage: 1\nstates: {Dark: {values: [yes, no], initial: no, external: true}}\n"
                  "roots: {Shine: {priority: 2}, Blink: {priority: 1}}\ngroups:\n"
                  "  Shine: {when: [Dark == yes], needs: [Lamp]}\n  Blink: {needs: [Lamp]}\n  Lamp: {}\n"
                  "assertions: [{soft: {from: Shine, to: Blink}}]\nallow: [uncovered_state, yaml_word_trap]\n"
                  "because: to try it\n");
  const std::string open = "directorc: not decided: soft {from: Shine, to: Blink}: not found in 5 states, and there are "
                           "more; `--bound N` of `directorc explore`, `check`, `generate` and `docs` tries more\n";
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"check", "lamp.yaml"}, {"generate", "lamp.yaml", "-o", "out"}}) {
    std::vector<std::string> bounded = words;
    bounded.push_back("--bound=2");
    CHECK(world.directorc(bounded) == 3);
    CHECK(world.err == open);
    CHECK(world.outputs.written.empty());
    bounded.back() = "--bound=1000";
    CHECK(world.directorc(bounded) == 0);
    CHECK(world.err.empty());
  }
  CHECK_FALSE(world.outputs.written.empty());
}

TEST_CASE("what only exploring finds is reported on request, with its extent if it was not complete") {
  // `Look` always requests `Head` first. The order of two equals is not analysed if one has another rank too.
  const std::string head = "behaviour: look\nlanguage: 1\nroots: [Play]\ngroups:\n  Play:\n"
                           "    allow: [equal_priority]\n    because: who asks first keeps it\n    packs:\n"
                           "      attack: {Look: {priority: 10}, Head: {priority: 10, apart: true}}\n"
                           "      rest: {Look: {}}\n";
  const std::string rest = "  Look: {needs: [Head], packs: {turn: {Head: {}}}}\n";
  World world;
  world.files.add("look.yaml", head + rest + "  Head: {}\n");
  CHECK(world.directorc({"check", "look.yaml"}) == 0);
  CHECK(world.out.empty());
  CHECK(world.directorc({"check", "--explore", "look.yaml"}) == 0);
  const std::string begin = "look.yaml:9:38: lint: `Head` never runs for `Play`, whatever happens [never_runs]\n";
  CHECK(world.out.substr(0, begin.size()) == begin);
  CHECK(world.out.ends_with("1 lint\n"));
  const std::string text = world.out;
  CHECK(world.directorc({"check", "--lint=never_runs", "look.yaml"}) == 0);
  CHECK(world.out == text);
  CHECK(world.directorc({"check", "--explore", "--bound=3", "look.yaml"}) == 3);
  CHECK(world.out.empty());
  const std::string open = "what never runs: 8 states were found, and there are more; `--bound N` tries more";
  CHECK(world.err == "directorc: not decided: " + open + "\n");
  CHECK(world.directorc({"check", "--explore", "--bound=3", "--format=json", "look.yaml"}) == 3);
  CHECK(world.out == "{\n  \"findings\": [],\n  \"not_decided\": [\n    \"" + open + "\"\n  ]\n}\n");
  CHECK(world.directorc({"check", "--explore", "--bound=3", "--format=sarif", "look.yaml"}) == 3);
  CHECK(world.out.find("\"text\": \"not decided: " + open + "\"") != std::string::npos);
  world.files.add("last.yaml", head + rest + "  Head: {providers: [{name: first}, {name: last}]}\n");
  CHECK(world.directorc({"check", "--explore", "--bound=3", "--werror", "last.yaml"}) == 1); // beside an error too
  CHECK(world.out.find("[shadowed_provider]") != std::string::npos);
  CHECK(world.err.find("directorc: not decided: what never runs: ") == 0);
}

TEST_CASE("an `allow` for what only exploring finds is not reported as unused without an exploration") {
  World world;
  world.files.add("lamp.yaml", "behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ngroups:\n"
                               "  Lamp: {allow: [never_runs], because: to try it}\n");
  CHECK(world.directorc({"check", "--werror", "lamp.yaml"}) == 0);
  CHECK(world.out.empty());
}

} // namespace

TEST_CASE("what does not apply to a module is named") {
  World world;
  world.files.add("legs.yaml", "behaviour: legs\nlanguage: 1\ngroups: {Legs: {}}\n");
  CHECK(world.directorc({"check", "legs.yaml"}) == 0);
  CHECK(world.err.empty());
  CHECK(world.directorc({"check", "--explore", "legs.yaml"}) == 0);
  CHECK(world.err ==
        "directorc: note: `legs.yaml` has no `roots`: a module alone cannot be played, so `--explore` adds "
        "nothing\n");
  CHECK(world.directorc({"check", "--verbose", "legs.yaml"}) == 0);
  CHECK(world.err ==
        "directorc: note: `legs.yaml` has no `roots`: how much memory and time a module takes depends on the "
        "deployment that imports it, so `--verbose` adds nothing\n");
}
