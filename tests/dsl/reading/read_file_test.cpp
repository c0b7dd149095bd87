// SPDX-License-Identifier: MIT
// Tests dsl/reading/read_file.hpp.
#include "dsl/reading/read_file.hpp"
#include "tests/dsl/reading/reading.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;

TEST_CASE("The head of a file is read with its places") {
  const Read read = read_text(R"(behaviour: soccer
language: 1
doc: A team's player.
cpp:
  namespace: soccer::play
  headers: [soccer/messages.hpp, <vector>]
layers: [purpose, skill]
triggers: [Sensors]
extern: [Say]
roots: [Walk]
limits: {trials: 500, pass: 600}
allow: [unused_causing]
because: Later.
)");
  REQUIRE(read.findings() == "");
  const BehaviourSpec& file = read.file();
  CHECK(file.file == FileId{0});
  CHECK(file.name.value == "soccer");
  CHECK(read.text(file.name.span) == "soccer");
  CHECK(file.doc->value == "A team's player.");
  CHECK(file.cpp.name_space->value == "soccer::play");
  CHECK(file.cpp.headers.at(1).value == "<vector>");
  CHECK(file.layers.at(1).value == "skill");
  CHECK(file.triggers.at(0).value == "Sensors");
  CHECK(file.externs.at(0).value == "Say");
  CHECK(file.roots->at(0).name.value == "Walk");
  CHECK(file.limits.trials->value == 500);
  CHECK(file.limits.pass->value == 600);
  CHECK(file.allow.at(0).id.value == "unused_causing");
  CHECK(file.span == Span{{0}, 0, static_cast<std::uint32_t>(read.sources[FileId{0}].text().size())});
}

TEST_CASE("A deployment that requests nothing is not a module") {
  CHECK(read_body("roots: []\n").file().roots);
  CHECK(read_body("roots: {}\n").file().roots);
  CHECK_FALSE(read_body("").file().roots);
}

TEST_CASE("Each kind of assertion names its groups") {
  const Read read = read_body(R"(assertions:
  - never_together: [Walk, GetUp, Kick]
  - beats: {FallRecovery: Striker}
  - can_run: Kick
  - soft: {to: Kick, from: Walk}
)");
  REQUIRE(read.findings() == "");
  const auto& assertions = read.file().assertions;
  REQUIRE(assertions.size() == 4);
  using Kind = AssertionSpec::Kind;
  CHECK(assertions[0].kind.value == Kind::never_together);
  CHECK(assertions[0].groups.size() == 3);
  CHECK(read.text(assertions[0].span) == "never_together: [Walk, GetUp, Kick]");
  CHECK(assertions[1].kind.value == Kind::beats);
  CHECK(assertions[1].groups.at(0).value == "FallRecovery");
  CHECK(assertions[1].groups.at(1).value == "Striker");
  CHECK(assertions[2].kind.value == Kind::can_run);
  CHECK(read.text(assertions[2].groups.at(0).span) == "Kick");
  CHECK(assertions[3].kind.value == Kind::soft);
  CHECK(assertions[3].groups.at(0).value == "Walk");
  CHECK(assertions[3].groups.at(1).value == "Kick");
}

TEST_CASE("What is wrong at the top of a file is reported at its place") {
  for (const Case& c : {
           Case{
               "",
               "1:1 `` wrong_node_kind: a behaviour file is a mapping, found nothing (it begins with `behaviour: name` "
               "and `language: 1`)\n"},
           Case{"- a\n", "1:1 `- a` wrong_node_kind: a behaviour file is a mapping, found a list (it begins with "
                         "`behaviour: name` and `language: 1`)\n"},
           Case{"Walk\n", "1:1 `Walk` wrong_node_kind: a behaviour file is a mapping, found `Walk` (it begins with "
                          "`behaviour: name` and `language: 1`)\n"},
           Case{"{}", "1:1 `{}` missing_key: a behaviour file needs `behaviour` (for example `behaviour: soccer`)\n"
                      "1:1 `{}` missing_key: a behaviour file needs `language` (for example `language: 1`)\n"},
           Case{"language: 1\n",
                "1:1 `language` missing_key: a behaviour file needs `behaviour` (for example `behaviour: soccer`)\n"},
           Case{"behavior: a\nlanguage: 1\n",
                "1:1 `behavior` unknown_key: a behaviour file has no key `behavior` (did you mean `behaviour`?)\n"},
           Case{
               "behaviour: a\nlanguage: 1\n\xC2\xA0groups: {}\n",
               "3:1 `\xC2\xA0groups` unknown_key: a behaviour file has no key `\xC2\xA0groups` (it has no-break spaces "
               "in it: write blanks in their place)\n"},
           Case{"behaviour: a\nlanguage: 1\ngroups:\n  A: {every: 10\xC2\xA0ms}\n",
                "4:14 `10\xC2\xA0ms` wrong_node_kind: `every`: expected a duration such as 10 ms, found `10\xC2\xA0ms` "
                "(it "
                "has no-break spaces in it: write blanks in their place)\n"},
           Case{
               "behaviour: a\nlanguage: 1\ngroups:\n  A\xEF\xBC\x9A{}\n",
               "4:3 `A\xEF\xBC\x9A{}` wrong_node_kind: `groups`: expected a mapping, found `A\xEF\xBC\x9A{}` (it has a "
               "full-width colon in it: write `: `)\n"},
           Case{"behaviour: a\nlanguage: 1\ngroups\xE2\x80\x8B: {}\n",
                "3:1 `groups\xE2\x80\x8B` unknown_key: a behaviour file has no key `groups\xE2\x80\x8B` (it has "
                "U+200B in it, which no key has)\n"},
           Case{"behaviour: a\nlanguage: 2\ngrups: {}\n", "2:11 `2` language_version: this compiler reads language 1, "
                                                          "found 2 (use the compiler that the file was written for)\n"},
           Case{"behaviour: a\nlanguage: one\n",
                "2:11 `one` wrong_node_kind: `language`: expected a whole number, found `one`\n"},
           Case{"behaviour: a\nlanguage: 99999999999999999999\n",
                "2:11 `99999999999999999999` wrong_node_kind: `language`: expected a whole number from "
                "-9223372036854775808 to 9223372036854775807, found `99999999999999999999`\n"},
           Case{"behaviour: [a]\nlanguage: 1\n",
                "1:12 `[a]` wrong_node_kind: `behaviour`: expected a name, found a list\n"},
           Case{"behaviour: a\nlanguage: 1\ngrops: {}\nstates:\nlayers: skill\ntriggers: {a: b}\n",
                "3:1 `grops` unknown_key: a behaviour file has no key `grops` (did you mean `groups`?)\n"
                "4:1 `states` wrong_node_kind: `states`: expected a mapping, found nothing (an empty one is `{}`)\n"
                "5:9 `skill` wrong_node_kind: `layers`: expected a list, found `skill` (write `[skill]`)\n"
                "6:11 `{a: b}` wrong_node_kind: `triggers`: expected a list, found a mapping (write `[a]`)\n"},
           Case{"behaviour: a\nlanguage: 1\ncpp: {name_space: b}\nlimits: {trials: 0}\n",
                "3:7 `name_space` unknown_key: `cpp` has no key `name_space` (did you mean `namespace`?)\n"
                "4:18 `0` wrong_node_kind: `trials`: expected a whole number from 1, found `0`\n"},
       }) {
    CAPTURE(c.text);
    CHECK(read_text(c.text).findings() == c.findings);
  }
}

TEST_CASE("Where nothing is there, an empty one is proposed only if it may be empty") {
  const auto help = [](const std::string& text) {
    const std::string findings = read_body(text).findings();
    const std::size_t found = findings.find(", found nothing"), open = findings.find(" (", found);
    CHECK(found != std::string::npos);
    return open == std::string::npos ? "" : findings.substr(open + 2, findings.size() - open - 4);
  };
  CHECK(help("states:\n") == "an empty one is `{}`");
  CHECK(help("groups:\n  A: {when: }\n") == "an empty one is `[]`");
  CHECK(help("states:\n  S:\n") == "for example `{values: [low, high]}`, or `{range: [0, 100]}`");
  CHECK(help("states: {S: {values: }}\n") == "for example `[low, high]`");
  CHECK(help("states: {S: {range: }}\n") == "for example `[0, 100]`");
  CHECK(help("groups: {A: {providers: }}\n") == "for example `[{name: walking}, {name: standing}]`");
  CHECK(help("groups:\n  A:\n    providers:\n      -\n") == "");
  CHECK(help("groups: {A: {packs: }}\n") == "for example `{attack: [Kick, Walk]}`; or leave `packs` out");
  CHECK(help("groups: {A: {tasks: {B: {levels: }}}}\n") == "for example `{normal: {priority: 10}}`");
  CHECK(help("extend:\n  A:\n") == "for example `{providers: [{name: quickly}]}`");
  CHECK(help("assertions:\n") == "an empty one is `[]`");
  CHECK(help("assertions:\n  -\n") == "");
  CHECK(help("assertions: [never_together: ]\n") == "for example `never_together: [Walk, GetUp]`");
  CHECK(help("assertions: [beats: ]\n") == "");
  CHECK(help("assertions: [soft: ]\n") == "");
}

TEST_CASE("What is wrong in an assertion is reported at its place") {
  for (const Case& c : {
           Case{"{can_run: Kick}",
                "3:13 `{can_run: Kick}` wrong_node_kind: `assertions`: expected a list, found a mapping (write `- ` "
                "before each of them)\n"},
           Case{"[Kick]",
                "3:14 `Kick` wrong_node_kind: `assertions`: expected a mapping such as {can_run: Kick}, found "
                "`Kick`\n"},
           Case{"[{}]",
                "3:14 `{}` wrong_node_kind: `assertions`: expected one of never_together, beats, can_run, soft, found "
                "none (for example `- can_run: Kick`)\n"},
           Case{"[{never: [A, B]}]",
                "3:15 `never` unknown_key: an assertion has no key `never` (assertions are about groups, "
                "`never_together: [Walk, Kick]`; a group that runs only with some values of states, `Rolls: {when: "
                "[Base == rolling]}`, stands for these)\n"},
           Case{"[{canrun: Kick}]",
                "3:15 `canrun` unknown_key: an assertion has no key `canrun` (did you mean `can_run`?)\n"},
           Case{"[{can_run: Kick, beats: {A: B}}]", "3:30 `beats` exclusive_keys: `can_run` and `beats` exclude each "
                                                    "other (write each as an entry of its own, with a `-`)\n"
                                                    "  3:15 `can_run` `can_run` stands here\n"},
           Case{"[never_together: [A]]", "3:30 `[A]` wrong_node_kind: `never_together`: expected two groups or more, "
                                         "found 1 (for example `never_together: [Walk, GetUp]`)\n"},
           Case{"[beats: [A, B]]",
                "3:21 `[A, B]` wrong_node_kind: `beats`: expected a mapping such as {Winner: Loser}, found "
                "a list\n"},
           Case{"[beats: {A: B, C: D}]", "3:21 `{A: B, C: D}` wrong_node_kind: `beats`: expected one pair {Winner: "
                                         "Loser}, found 2 (write an assertion for each pair)\n"},
           Case{"[soft: {from: A}]",
                "3:14 `soft` missing_key: `soft` needs `to` (for example `soft: {from: Walk, to: Kick}`)\n"},
           Case{"[can_run: [A]]",
                "3:23 `[A]` wrong_node_kind: `can_run`: expected the name of a group, found a list\n"},
       }) {
    CAPTURE(c.text);
    CHECK(read_body("assertions: " + std::string(c.text) + "\n").findings() == c.findings);
  }
}

TEST_CASE("All mistakes of a file are found in one run") {
  const Read read =
      read_body("states:\n  S: {}\ngroups:\n  A: {needs: B}\n  C: {when: [S = x], tasks: [D], packs: {p: [D]}}\n");
  CHECK(read.findings() ==
        "4:3 `S` missing_key: state `S` needs `values`, `range` or `type` (for example `values: [low, high]`, or "
        "`range: [0, 100]`)\n"
        "6:14 `B` wrong_node_kind: `needs`: expected a list, found `B` (write `[B]`)\n"
        "7:16 `=` bad_condition: expected one of ==, !=, <, <=, >, >= behind `S`, found `=` (write "
        "`==`)\n"
        "7:34 `packs` exclusive_keys: `tasks` and `packs` exclude each other (make one of the packs of the tasks)\n"
        "  7:22 `tasks` `tasks` stands here\n");
  CHECK(read.file().groups.size() == 2);
}
