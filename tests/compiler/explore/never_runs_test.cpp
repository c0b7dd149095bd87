// SPDX-License-Identifier: MIT
#include "compiler/explore/never_runs.hpp"
#include "tests/compiler/support/checked.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using compiler::NeverRuns;

/// Two states whose values never coincide as `Enter.peeping` requires.
const std::string door =
    "states: {Door: {values: [shut, open], initial: shut}, Lamp: {values: [dark, lit], initial: dark}}\n"
    "roots: [Enter]\ngroups:\n  Enter:\n    providers:\n"
    "      - {name: peeping, when: [Door == shut, Lamp == lit], tasks: [Look]}\n"
    "      - {name: opening, when: [Door == shut], sets: [Door == open]}\n"
    "      - {name: lighting, sets: [Lamp == lit]}\n"
    "  Look: {}\n";

std::vector<std::string> messages(const NeverRuns& never) {
  std::vector<std::string> out;
  for (const dsl::Diagnostic& finding : never.findings) out.push_back(finding.message);
  return out;
}

NeverRuns explore(const std::string& text, std::size_t bound = 100'000) {
  const tests::CheckedText checked = tests::check_text(text);
  REQUIRE(checked.checked.lowerable);
  return compiler::find_never_runs(checked.checked.model, bound, checked.checked.findings);
}

TEST_CASE("what never ran is reported, and not what only that would have requested") {
  // The checks find this as well: their findings are left out.
  const tests::CheckedText checked = tests::check_text(door);
  REQUIRE(checked.checked.lowerable);
  const NeverRuns never = compiler::find_never_runs(checked.checked.model, 100'000, {});
  CHECK(never.open == "");
  CHECK(messages(never) == std::vector<std::string>{"`Enter.peeping` never runs, whatever happens"});
  CHECK(messages(explore(door)).empty());
}

TEST_CASE("with more states than the bound nothing is reported") {
  const NeverRuns never = explore(door, 2);
  CHECK(never.open == "2 states were found, and there are more; `--bound N` tries more");
  CHECK(never.findings.empty());
}

TEST_CASE("what another finding reports is not reported again") {
  const NeverRuns never = explore("states: {Door: {values: [shut, open], initial: shut}}\nroots: [Enter]\ngroups:\n"
                                  "  Enter:\n    providers:\n      - {name: entering, when: [Door == open]}\n"
                                  "      - {name: knocking}\n");
  CHECK(never.open == "");
  CHECK(messages(never).empty());
}

/// The order of two requests of equal rank is not analysed if one of them has another rank elsewhere.
TEST_CASE("of many requests that never succeed some are noted, and how many more there are") {
  std::string packs;
  for (std::size_t i = 0; i < 60; ++i)
    packs += "p" + std::to_string(i) + ": {Look: {priority: 10}, Head: {priority: 10, apart: true}}, ";
  const NeverRuns never =
      explore("allow: [equal_priority]\nbecause: who asks first keeps it\nroots: [Play]\ngroups:\n  Play: {packs: {" +
              packs + "rest: {Look: {}}}}\n  Look: {needs: [Head], packs: {turn: {Head: {}}}}\n  Head: {}\n");
  CHECK(messages(never) == std::vector<std::string>{"`Head` never runs for `Play`, whatever happens"});
  const std::vector<dsl::Note>& notes = never.findings.at(0).notes;
  REQUIRE(notes.size() == 8);
  CHECK(notes[6].message == "`Head` is requested here too");
  CHECK(notes[7].message == "and 52 more of such notes, from here on");
}

TEST_CASE("of a task that never runs the entries are noted at which it was requested, and no others") {
  const tests::CheckedText checked = tests::check_text(
      "states: {Door: {values: [shut, open], initial: shut}, Lamp: {values: [dark, lit], initial: dark}}\n"
      "roots: [Enter]\ngroups:\n  Enter:\n    providers:\n"
      "      - {name: peeping, when: [Door == shut, Lamp == lit], tasks: [Greet]}\n"
      "      - {name: opening, when: [Door == shut], sets: [Door == open]}\n"
      "      - {name: lighting, sets: [Lamp == lit], tasks: [Look]}\n"
      "  Greet: {tasks: [Look]}\n  Look: {when: [Door == shut, Lamp == lit]}\n");
  REQUIRE(checked.checked.lowerable);
  const NeverRuns never = compiler::find_never_runs(checked.checked.model, 100'000, {});
  CHECK(messages(never) == std::vector<std::string>{"`Look` never runs, whatever happens",
                                                    "`Enter.peeping` never runs, whatever happens"});
  CHECK(never.findings.at(0).notes.size() == 1);
}

TEST_CASE("a task that runs for others is reported at the entry where it never does") {
  // No check reports a root task, which the program may as well not request; here the findings are left out.
  const tests::CheckedText checked =
      tests::check_text("roots: [Plan, Walk]\ngroups:\n  Plan: {needs: [Legs], packs: {go: {Step: {}}}}\n"
                        "  Step: {packs: {go: {Legs: {}}}}\n  Walk: {tasks: [Legs]}\n  Legs: {}\n");
  REQUIRE(checked.checked.lowerable);
  CHECK(messages(compiler::find_never_runs(checked.checked.model, 100'000, {})) ==
        std::vector<std::string>{"`Legs` never runs for `Step`, whatever happens"});
  CHECK(messages(compiler::find_never_runs(checked.checked.model, 100'000, checked.checked.findings)).empty());
}

} // namespace
