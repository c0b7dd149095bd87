// SPDX-License-Identifier: MIT
// Tests dsl/reading/print_spec.hpp.
#include "dsl/reading/print_spec.hpp"
#include "tests/dsl/reading/reading.hpp"
#include "tests/dsl/reading/without_places.hpp"

#include <catch2/catch.hpp>

#include <filesystem>

using namespace director::dsl;

namespace {

constexpr const char* everything = R"(# Every key of the language.
behaviour: soccer
language: 1
doc: "A team's player: #1.\n\tTwo lines."
allow: [unused_declaration, useless_use]
because: It grows.
cpp:
  namespace: soccer
  headers: ["soccer/messages.hpp"]
layers: [purpose, "on"]
states:
  Stability:
    doc: How it stands.
    values: [unknown, fallen, standing]
    unordered: [unknown]
    initial: unknown
    external: true
    allow: [unused_declaration]
    because: Later.
  Phase: {type: "soccer::GamePhase", values: [ready, set]}
  Charge: {range: [-1, 100], external: false, expires: 500 ms, initial: 3}
  Link: {values: [lost, up], external: true, expires: {after: 2s, to: lost}}
  Approach: {values: [far, near], initial: far, of: Striker}
triggers: [Sensors]
extern: [Say]
roots:
  FallRecovery: {priority: 90, doc: Safety first.}
  Striker: {priority: {normal: -10, urgent: 80}, optional: true, allow: [equal_priority], because: Both may.}
  Look: {levels: {firm: {priority: 50, apart: true}, spare: {}}}
groups:
  Striker:
    doc: Plays.
    layer: purpose
    module: strategy
    providers:
      - name: playing
        doc: The game is on.
        when: [Phase==ready | set, Charge >= -1]
        packs:
          attack: {Kick: {priority: 20}, Look: {optional: true}, Report: {apart: true}}
          search: [Look]
          rest: {}
        allow: [possible_pack_conflict]
        because: It is rare.
      - {name: waiting, stay: [Phase != set], every: 1 min, tasks: []}
  Walk:
    data: soccer::WalkCommand
    realtime: true
    start: true
    stop: {sets: [Stability == unknown, Charge]}
    uses: [LeftLeg]
    sets: [Stability]
    triggers: [Sensors]
    providers:
      - name: halting
        needs: [LeftLeg, RightLeg]
        causing: [Stability == standing within 2 s]
        sets: [Stability == unknown]
        triggers: [Walk.halting.broken]
        uses: [RightLeg]
        tasks: {LeftLeg: {}, RightLeg: {}}
  Kick: {when: [Stability == standing], tasks: [LeftLeg], allow: [unused_need], because: "y"}
  LeftLeg: {}
  None: {providers: []}
extend:
  GetUp:
    doc: Faster.
    before: slowly
    providers: [{name: quickly, needs: [LeftLeg]}]
assertions:
  - never_together: [Walk, GetUp]
  - beats: {FallRecovery: Striker}
  - can_run: Kick
  - soft: {from: Walk, to: Kick}
limits: {trials: 5, pass: 6}
)";

constexpr const char* normal_form = R"(--- # main.yaml
behaviour: soccer
language: 1
doc: "A team's player: #1.\n\tTwo lines."
cpp: {namespace: soccer, headers: [soccer/messages.hpp]}
layers: [purpose, "on"]
states:
  Stability: {doc: How it stands., values: [unknown, fallen, standing], unordered: [unknown], initial: unknown, external: true, allow: [unused_declaration], because: Later.}
  Phase: {type: soccer::GamePhase, values: [ready, set]}
  Charge: {range: [-1, 100], initial: 3, expires: {after: 500 ms}}
  Link: {values: [lost, up], external: true, expires: {after: 2 s, to: lost}}
  Approach: {values: [far, near], initial: far, of: Striker}
triggers: [Sensors]
extern: [Say]
roots:
  FallRecovery: {priority: 90, doc: Safety first.}
  Striker: {levels: {normal: {priority: -10, optional: true}, urgent: {priority: 80, optional: true}}, allow: [equal_priority], because: Both may.}
  Look: {levels: {firm: {priority: 50, apart: true}, spare: {}}}
groups:
  Striker:
    doc: Plays.
    layer: purpose
    module: strategy
    providers:
      - name: playing
        doc: The game is on.
        when: [Phase == ready|set, Charge >= -1]
        packs: {attack: {Kick: {priority: 20}, Look: {optional: true}, Report: {apart: true}}, search: [Look], rest: []}
        allow: [possible_pack_conflict]
        because: It is rare.
      - name: waiting
        stay: [Phase != set]
        every: 1 min
        tasks: []
  Walk:
    data: soccer::WalkCommand
    realtime: true
    start: true
    stop: {sets: [Stability == unknown, Charge]}
    uses: [LeftLeg]
    sets: [Stability]
    triggers: [Sensors]
    providers:
      - name: halting
        needs: [LeftLeg, RightLeg]
        causing: [Stability == standing within 2 s]
        sets: [Stability == unknown]
        uses: [RightLeg]
        triggers: [Walk.halting.broken]
        tasks: [LeftLeg, RightLeg]
  Kick:
    when: [Stability == standing]
    tasks: [LeftLeg]
    allow: [unused_need]
    because: "y"
  LeftLeg: {}
  None:
    providers: []
extend:
  GetUp:
    doc: Faster.
    before: slowly
    providers:
      - name: quickly
        needs: [LeftLeg]
assertions:
  - never_together: [Walk, GetUp]
  - beats: {FallRecovery: Striker}
  - can_run: Kick
  - soft: {from: Walk, to: Kick}
limits: {trials: 5, pass: 6}
allow: [unused_declaration, useless_use]
because: It grows.
)";

} // namespace

TEST_CASE("A behaviour file is printed in its normal form") {
  const Read read = read_text(everything);
  REQUIRE(read.findings() == "");
  CHECK(print_spec(read.result.spec, read.sources) == normal_form);
}

TEST_CASE("What was printed reads as an equal Spec, and prints as it was") {
  const Read read = read_text(everything);
  const Read again = read_text(print_spec(read.result.spec, read.sources));
  CHECK(again.findings() == "");
  CHECK(without_places(again.result.spec) == without_places(read.result.spec));
  CHECK(print_spec(again.result.spec, again.sources) == normal_form);
}

TEST_CASE("Texts of every kind come back") {
  for (const char* text :
       {"plain", "with blanks", " leading", "trailing ", "",    "~",     "null", "y",    "a: b", "a #b", "# a",
        "- a",   "-5",          "[a]",      "a, b",      "{",   "\"",    "'",    "it's", "\\",   "ü",    "a\nb\n",
        "\t",    "\r\n",        "\x01",     "*a",        "&a",  "!a",    "a:",   ":a",   "a::b", "|",    ">",
        "%a",    "@",           "`",        "...",       "---", "... a", "?",    "? a",  "=",    "0x1",  "1e3"}) {
    Read read = read_body("");
    BehaviourSpec file = read.file();
    file.doc = Word{text, {}};
    file.layers = {Word{text[0] ? text : "x", {}}};
    const std::string printed = print_file(file);
    CAPTURE(printed);
    const Read again = read_text(printed);
    CHECK(again.findings() == "");
    REQUIRE(again.result.spec.files.size() == 1);
    CHECK(again.file().doc->value == text);
    CHECK(again.file().layers.at(0).value == file.layers[0].value);
  }
}

TEST_CASE("Several files are printed in order of declaration") {
  Read read;
  read.files.add("main.yaml", "behaviour: m\nlanguage: 1\nimports: [a.yaml]\n");
  read.files.add("a.yaml", "behaviour: a\nlanguage: 1\n");
  read.result = read_behaviour("main.yaml", read.files, read.sources);
  CHECK(print_spec(read.result.spec, read.sources) ==
        "--- # a.yaml\nbehaviour: a\nlanguage: 1\n"
        "--- # main.yaml\nbehaviour: m\nlanguage: 1\nimports: [a.yaml]\n");
}

TEST_CASE("Every behaviour of this project comes back as it was") {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator("behaviours")) {
    const std::string path = entry.path().string();
    if (!path.ends_with(".yaml") || path.ends_with(".scenario.yaml")) continue;
    CAPTURE(path);
    DiskFiles disk;
    Sources sources;
    const ReadResult first = read_behaviour(path, disk, sources);
    CHECK(findings_text(first.diagnostics, sources) == "");
    Read again;
    for (const BehaviourSpec& file : first.spec.files) again.files.add(sources[file.file].path(), print_file(file));
    again.result = read_behaviour(path, again.files, again.sources);
    CHECK(again.findings() == "");
    CHECK(without_places(again.result.spec) == without_places(first.spec));
    ++count;
  }
  CHECK(count > 0);
}
