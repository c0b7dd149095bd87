// SPDX-License-Identifier: MIT
#include "compiler/analysis/needs/needs.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

std::string faults(const std::string& groups) {
  Budget budget;
  const tests::Analysed test("roots: []\ngroups:\n" + groups);
  std::string out;
  for (const auto& cycle : find_need_cycles(test.model, test.graph, test.facts, budget)) {
    out += "circle";
    for (const ChainStep& step : cycle) out += " " + test.model.groups[step.from].name.value;
    out += "\n";
  }
  for (const ProviderId id : find_need_conflicts(test.model, test.facts, budget))
    out += "conflict " + test.model.full_name(id) + "\n";
  return out;
}

TEST_CASE("only the cycle itself is at fault, not a group that needs a part of it") {
  CHECK(faults("  A: {needs: [B]}\n  B: {needs: [C]}\n  C: {needs: [D]}\n  D: {needs: [B]}\n") == "circle B C D\n");
}

TEST_CASE("two cycles are two faults") {
  CHECK(faults("  A: {needs: [B]}\n  B: {needs: [A, C]}\n  C: {needs: [C]}\n") == "circle A B\ncircle C\n");
}

TEST_CASE("a cycle that one provider leads out of is none") {
  CHECK(faults("  A: {needs: [B]}\n  B: {providers: [{name: x, needs: [C]}, {name: y}]}\n  C: {providers: [{name: x, "
               "needs: [B]}, {name: y}]}\n")
            .empty());
}

TEST_CASE("a conflict below is not reported again above") {
  CHECK(faults("  A: {needs: [B]}\n  B: {needs: [C, D]}\n  C: {needs: [E]}\n  D: {needs: [E]}\n  E: {}\n") ==
        "conflict B\n");
}

TEST_CASE("a provider whose own group is needed below it is in a cycle") {
  CHECK(faults("  A: {providers: [{name: x, needs: [B]}, {name: y}]}\n  B: {needs: [A]}\n") == "circle A B\n");
}

} // namespace
