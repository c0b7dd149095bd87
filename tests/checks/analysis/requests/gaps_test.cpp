#include "compiler/checks/analysis/requests/gaps.hpp"
#include "tests/checks/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::checks;

/// What no way of the group covers, one combination a line.
std::string gaps_of(const char* group, const std::string& text, bool with_stay = true) {
  const tests::Analysed test(text);
  const Model& model = test.model;
  const Facts& facts = test.facts;
  Ways ways(model, facts, with_stay, [](ProviderId, const ConditionUse&) { return true; });
  const auto boxes = find_gaps(model, facts, {}, ways.of(test.group(group)));
  if (!boxes) return "too many";
  std::string out;
  for (const Box& box : *boxes) out += gap_in_words(model, facts, box) + "\n";
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

TEST_CASE("a stay covers where it is asked for") {
  const std::string text = states + "  G: {when: [B == 1], stay: [B >= 0]}\n";
  CHECK(gaps_of("G", text) == "");
  CHECK(gaps_of("G", text, false) == "while `B` is 0\n");
}

TEST_CASE("a group runs only where its needs can be met") {
  CHECK(gaps_of("G", states + "  G: {needs: [N]}\n  N: {providers: [{name: a, when: [B == 1]}, {name: b, needs: "
                              "[M]}]}\n  M: {when: [A > 4]}\n") == "while `A` is 0 to 4 or unset and `B` is 0\n");
}

} // namespace
