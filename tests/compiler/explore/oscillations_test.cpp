// SPDX-License-Identifier: MIT
#include "compiler/explore/oscillations.hpp"
#include "tests/compiler/explore/explored.hpp"

using namespace director::compiler;
using director::tests::explore_all;

TEST_CASE("a body that keeps a promise in a cycle is distinguished from one that sets what it may") {
  const auto oscillations = [](const std::string& declared) {
    const auto compiled = director::tests::compile("behaviour: b\nlanguage: 1\n"
                                                   "states: {S: {values: [x, y], initial: x}}\n"
                                                   "roots: {A: {priority: 20}, B: {priority: 10}}\n"
                                                   "groups:\n"
                                                   "  A: {when: [S == x], needs: [L], " +
                                                   declared +
                                                   "}\n"
                                                   "  B: {needs: [L]}\n"
                                                   "  L: {}\n");
    const Ground ground(compiled.model);
    std::vector<std::string> out;
    const Exploration exploration = explore_all(ground);
    for (const Oscillation& each : exploration.oscillations) out.push_back(in_words(ground, each));
    CHECK(never_at_rest(ground, exploration.oscillations).empty() ==
          (out.empty() || exploration.oscillations.front().keeps_promises));
    return out;
  };
  using Words = std::vector<std::string>;
  CHECK(oscillations("stop: {sets: [S == x]}, causing: [S == y]") ==
        Words{"Never at rest, if what is promised takes no time: after request A it repeats 2 micro-steps: A"});
  CHECK(oscillations("start: {sets: [S == y]}, stop: {sets: [S == x]}") ==
        Words{"Never at rest: after request A it repeats 2 micro-steps: A"});
  CHECK(oscillations("stop: {sets: [S == x]}, sets: [S == y]").empty()); // it need not set it
}

TEST_CASE("of many that go round some are noted, and how many more there are") {
  std::string ways, tasks;
  for (int each = 0; each < 6; ++each) {
    const std::string n = std::to_string(each), next = std::to_string((each + 1) % 6);
    ways += "      - {name: p" + n + ", when: [S == " + n + "], tasks: [T" + n + "]}\n";
    tasks += "  T" + n + ": {start: {sets: [S == " + next + "]}}\n";
  }
  const auto compiled = director::tests::compile("behaviour: b\nlanguage: 1\nstates: {S: {range: [0, 5], initial: 0}}\n"
                                                 "roots: [A]\ngroups:\n  A:\n    providers:\n" +
                                                 ways + tasks);
  const Ground ground(compiled.model);
  const auto findings = never_at_rest(ground, explore_all(ground).oscillations);
  REQUIRE(!findings.empty());
  const std::vector<director::dsl::Note>& notes = findings.front().notes;
  REQUIRE(notes.size() == 8);
  CHECK(notes[6].message == "`T1` runs, starts or stops in it");
  CHECK(notes[7].message == "and 4 more of such notes, from here on");
}
