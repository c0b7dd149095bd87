// SPDX-License-Identifier: MIT
#include "compiler/analysis/plans/trials.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

std::int64_t decision(const std::string& groups) {
  const tests::Analysed test("roots: [All]\ngroups:\n" + groups);
  Budget budget;
  Trials trials(test.model, 1000, budget);
  return trials.decision(trials.together(test.model.providers[test.provider("All")].packs.front())).count;
}

std::string group_of_ten() {
  std::string out = "{providers: [";
  for (char letter = 'a'; letter <= 'j'; ++letter)
    out += std::string(letter == 'a' ? "" : ", ") + "{name: by_" + letter + "}";
  return out + "]}\n";
}
const std::string ten = group_of_ten();

TEST_CASE("members that share no group add up") {
  CHECK(decision("  All: {tasks: [A, B, C, D]}\n  A: " + ten + "  B: " + ten + "  C: " + ten + "  D: " + ten) ==
        2 * 40);
}

TEST_CASE("members that can claim the same group multiply, and the others do not") {
  const std::string two = "{providers: [{name: one, needs: [Left]}, {name: two, needs: [Right]}]}\n";
  CHECK(decision("  All: {tasks: [A, B, C]}\n  A: " + two + "  B: " + two + "  C: " + ten +
                 "  Left: {}\n  Right: {}\n") == 2 * 14 + (2 * 2 + 10));
}

TEST_CASE("what is optional or apart is no member") {
  CHECK(decision("  All: {tasks: {A: {}, B: {optional: true}, C: {apart: true}}}\n  A: " + ten + "  B: " + ten +
                 "  C: " + ten) == 10);
}

TEST_CASE("more plans than are counted are reported as a lower bound") {
  const tests::Analysed test("roots: [A]\ngroups:\n  A: {needs: [B, C]}\n  B: " + ten + "  C: " + ten);
  Budget budget;
  Trials trials(test.model, 7, budget);
  const TrialCount count = trials.decision(trials.alone(test.model.roots.front()));
  CHECK(count.count == 7);
  CHECK_FALSE(count.complete);
}

TEST_CASE("the trials of a pass are summed for each component, by what requests it") {
  const tests::Analysed test("roots: [A, C]\ngroups:\n  A: {tasks: [B]}\n  B: " + ten + "  C: {}\n");
  Budget budget;
  Trials trials(test.model, 1000, budget);
  const std::vector<PassTrials> passes = trials.passes();
  REQUIRE(passes.size() == 2);
  const PassTrials& whole = passes[trials.component(test.group("A"))];
  CHECK(whole.sum.count == trials.pass(test.model.roots.front()).count + trials.pass(test.group("A")).count.count);
  REQUIRE(whole.shares.size() == 2);
  CHECK(whole.shares[0].root == &test.model.roots.front());
  CHECK(whole.shares[1].provider == test.provider("A"));
  CHECK(passes[trials.component(test.group("C"))].shares.size() == 1);
}

} // namespace
