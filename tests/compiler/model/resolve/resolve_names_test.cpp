// SPDX-License-Identifier: MIT
#include "tests/compiler/support/checked.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;

std::string findings(const std::string& text) { return tests::check_text(text).findings(); }

TEST_CASE("faults in what is declared twice are found all the same") {
  CHECK(findings("roots: [Walk]\ngroups:\n  Walk: {providers: [{name: a}, {name: a, needs: [Lgs]}]}\n  Legs: {}\n") ==
        "main.yaml:5: the provider `a` of `Walk` is declared twice [redefined_name]\n"
        "main.yaml:5: there is no group called `Lgs` [undefined_name]\n");
}

TEST_CASE("a name with a character that looks like another one, or like nothing") {
  const tests::CheckedText text = tests::check_text("roots: [\xD0\x90]\ngroups:\n  A: {needs: [Legs\xE2\x80\x8B]}\n"
                                                    "  Legs: {}\n  B\xD0\x90: {}\n");
  std::string helps;
  for (const dsl::Diagnostic& finding : text.checked.findings) helps += finding.help + "\n";
  CHECK(text.findings() == "main.yaml:3: there is no group called `\xD0\x90` [undefined_name]\n"
                           "main.yaml:5: there is no group called `Legs\xE2\x80\x8B` [undefined_name]\n"
                           "main.yaml:7: `B\xD0\x90` is no name for a group [reserved_name]\n");
  CHECK(helps == "a name has letters from a to z or A to Z, digits and `_`, but not U+0410, as this one has\n"
                 "a name has letters from a to z or A to Z, digits and `_`, but not U+200B, as this one has\n"
                 "a name has letters from a to z or A to Z, digits and `_`, but not U+0410, as this one has\n");
}

TEST_CASE("providers that lack their names are not declared twice") {
  CHECK(findings("roots: [Walk]\ngroups:\n  Walk: {providers: [{needs: [Legs]}, {tasks: [Legs]}]}\n  Legs: {}\n") ==
        "main.yaml:5: a provider needs `name` [missing_key]\n"
        "main.yaml:5: a provider needs `name` [missing_key]\n");
}

TEST_CASE("a reserved name of a provider is not called declared twice too") {
  CHECK(findings("roots: [A]\ngroups: {A: {}}\nextend: {A: {providers: [{name: default}]}}\n") ==
        "main.yaml:5: a provider cannot be called `default`: that is a keyword of C++ [reserved_name]\n");
}

TEST_CASE("a task that is listed twice") {
  CHECK(findings("roots: [Walk]\ngroups:\n  Walk: {tasks: [Legs, Legs]}\n  Legs: {}\n") ==
        "main.yaml:5: `Legs` is listed twice [redefined_name]\n");
}

TEST_CASE("roots of an imported file must mean something too") {
  const auto text = tests::check_files({{"main.yaml", tests::beginning("robot") + "imports: [a.yaml]\nroots: [A]\n"},
                                        {"a.yaml", tests::beginning("a") + "roots: [B]\ngroups: {A: {}}\n"}});
  CHECK(text.findings() == "a.yaml:3: there is no group called `B` [undefined_name]\n");
}

TEST_CASE("levels of one name in several requests are no fault") {
  CHECK(findings("roots: {Walk: {priority: {calm: 1, brisk: 2}}, Run: {priority: 3}}\n"
                 "groups:\n  Walk: {}\n  Run: {tasks: {Legs: {priority: {calm: 1, brisk: 2}}}}\n  Legs: {}\n")
            .empty());
}

TEST_CASE("a level cannot be called like the group that it requests") {
  CHECK(findings("roots: {Walk: {priority: {Walk: 1}}}\ngroups: {Walk: {}}\n") ==
        "main.yaml:3: the level `Walk` is called like the group that it requests [redefined_name]\n");
}

TEST_CASE("nobody knows the providers of an extern group until a deployment has them") {
  const std::string sensor = tests::beginning("sensor") +
                             "extern: [Walk]\ngroups: {A: {triggers: [Walk.halting.broken], tasks: [Walk]}}\n"
                             "extend: {Walk: {before: halting, providers: [{name: limping}]}}\n";
  CHECK(tests::check_files({{"main.yaml", sensor}}).findings() == "");
  const std::string robot = tests::beginning("robot") + "imports: [sensor.yaml]\nroots: [A]\n";
  const auto walk = [](const std::string& provider) {
    return "states: {S: {values: [a, b], initial: a}}\ngroups: {Walk: {providers: [" + provider + "]}}\n";
  };
  const std::map<std::string, std::string> whole{{"main.yaml", robot + walk("{name: halting, causing: [S == b within 1 s]}")},
                           {"sensor.yaml", sensor}};
  CHECK(tests::check_files(whole).findings().find("undefined_name") == std::string::npos);
  const std::map<std::string, std::string> without{{"main.yaml", robot + walk("{name: stopping}")}, {"sensor.yaml", sensor}};
  const std::string said = tests::check_files(without).findings();
  CHECK(said.find("there is no promise `Walk.halting.broken`") != std::string::npos);
  CHECK(said.find("`Walk` has no provider called `halting`") != std::string::npos);
}

TEST_CASE("for a misspelt promise the nearest one is proposed") {
  const auto said = tests::check_text("roots: [A, Walk]\nstates: {S: {values: [a, b], initial: a}}\n"
                                      "groups: {A: {triggers: [Walk.haltng.broken]}, Walk: {providers: [{name: halting, "
                                      "causing: [S == b within 1 s]}]}}\n");
  REQUIRE(said.checked.findings.size() == 1);
  CHECK(said.checked.findings[0].help == "did you mean `Walk.halting.broken`?");
}

TEST_CASE("an extern that two files name is reported in both") {
  const auto text =
      tests::check_files({{"main.yaml", tests::beginning("robot") + "imports: [a.yaml]\nextern: [Say]\nroots: [A]\n"},
                          {"a.yaml", tests::beginning("a") + "extern: [Say]\ngroups: {A: {tasks: [Say]}}\n"}});
  CHECK(text.findings() == "main.yaml:4: nothing provides `Say` [unprovided_task]\n"
                           "a.yaml:3: nothing provides `Say` [unprovided_task]\n");
}

TEST_CASE("a module lists names under extern that no group can have") {
  CHECK(findings("extern: [class, start, a-b, Q]\nstates: {Q: {values: [a, b], initial: a, external: true}}\n"
                 "groups: {M: {when: [Q == a], tasks: [class, start, a-b, Q]}}\n") ==
        "main.yaml:3: a group cannot be called `class`: that is a keyword of C++ [reserved_name]\n"
        "main.yaml:3: a group cannot be called `start`: that is a word of Director's own [reserved_name]\n"
        "main.yaml:3: `a-b` is no name for a group [reserved_name]\n"
        "main.yaml:3: the group `Q` and the state `Q` become one name in C++, `Q` [redefined_name]\n");
}

TEST_CASE("a deployment lacks a group whose name none can have") {
  CHECK(findings("extern: [class]\nroots: [class]\n") ==
        "main.yaml:3: a group cannot be called `class`: that is a keyword of C++ [reserved_name]\n");
}

TEST_CASE("a name is listed twice under extern") {
  CHECK(findings("extern: [Say, Say]\ngroups: {A: {tasks: [Say]}}\n") ==
        "main.yaml:3: `Say` is listed twice [redefined_name]\n");
}

TEST_CASE("files list the same name under extern") {
  const auto text = tests::check_files(
      {{"main.yaml", tests::beginning("b") + "imports: [a.yaml]\nextern: [Say]\ngroups: {B: {tasks: [Say]}}\n"},
       {"a.yaml", tests::beginning("a") + "extern: [Say]\ngroups: {A: {tasks: [Say]}}\n"}});
  CHECK(text.findings().empty());
}

TEST_CASE("a promise of a provider called default") {
  CHECK(findings(
            "states: {P: {values: [a, b], initial: a, external: true}}\nroots: {W: {priority: 1}, K: {priority: 2}}\n"
            "groups:\n  W: {causing: [P == b within 1 s], triggers: [W.default.broken]}\n  K: {when: [P == b]}\n")
            .empty());
}

} // namespace
