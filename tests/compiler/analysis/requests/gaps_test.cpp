// SPDX-License-Identifier: MIT
#include "compiler/analysis/requests/gaps.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace {

using namespace director;
using namespace director::analysis;

/// The gaps of the group, one combination a line.
std::string gaps_of(const char* group, const std::string& text, bool with_stay = true) {
  const tests::Analysed test(text);
  const Model& model = test.model;
  const Facts& facts = test.facts;
  Ways ways(model, facts, with_stay, [](ProviderId, const ConditionUse&) { return true; });
  Budget budget;
  const Gaps gaps = find_gaps(model, facts, {}, ways.of(test.group(group)), budget);
  std::string out = !gaps.decided ? "not decided\n" : gaps.all ? "" : "one of many\n";
  for (const Box& box : gaps.boxes) out += gap_in_words(model, facts, box) + "\n";
  return out;
}

const std::string states = "states: {A: {range: [0, 9], external: true}, B: {range: [0, 1], initial: 0, external: "
                           "true}}\nroots: [G]\ngroups:\n";

TEST_CASE("an unset state is covered by no condition") {
  CHECK(gaps_of("G", states + "  G: {when: [A != 3]}\n") == "while `A` is 3 or unset\n");
  CHECK(gaps_of("G", states + "  G: {when: [B <= 1]}\n") == "");
}

TEST_CASE("combinations that nothing covers are listed without overlap") {
  CHECK(gaps_of("G", states + "  G: {providers: [{name: a, when: [A > 5, B == 0]}, {name: b, when: [A < 3]}]}\n") ==
        "while `A` is 3 to 5 or unset\nwhile `A` is 6 to 9 and `B` is 1\n");
}

TEST_CASE("a stay covers where it is requested") {
  const std::string text = states + "  G: {when: [B == 1], stay: [B >= 0]}\n";
  CHECK(gaps_of("G", text) == "");
  CHECK(gaps_of("G", text, false) == "while `B` is 0\n");
}

TEST_CASE("a group runs only where its needs can be met") {
  CHECK(gaps_of("G", states + "  G: {needs: [N]}\n  N: {providers: [{name: a, when: [B == 1]}, {name: b, needs: "
                              "[M]}]}\n  M: {when: [A > 4]}\n") == "while `A` is 0 to 4 or unset and `B` is 0\n");
}

TEST_CASE("of more gaps than can be listed one is reported") {
  std::string text = "states:\n";
  for (int i = 0; i < 40; ++i) text += fmt::format("  S{}: {{range: [0, 1], initial: 0, external: true}}\n", i);
  text += "roots: [G]\ngroups:\n  G:\n    providers:\n";
  for (int i = 0; i < 40; i += 4)
    text += fmt::format("      - {{name: p{0}, when: [S{0} == 1, S{1} == 1, S{2} == 1, S{3} == 1]}}\n", i, i + 1, i + 2,
                        i + 3);
  CHECK(
      gaps_of("G", text) ==
      "one of many\nwhile `S0` is 0, `S4` is 0, `S8` is 0, `S12` is 0, `S16` is 0, `S20` is 0, `S24` is 0, `S28` is 0, "
      "`S32` is 0 and `S36` is 0\n");
}

} // namespace
