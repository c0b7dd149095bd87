// SPDX-License-Identifier: MIT
#include "compiler/analysis/plans/plans.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

const std::string head = "roots: []\ngroups:\n";

TEST_CASE("plans are counted without those that use a group twice") {
  const tests::Analysed test(head + R"(
  Juggle: {needs: [First, Second]}
  First: {providers: [{name: left, needs: [Left]}, {name: right, needs: [Right]}]}
  Second: {providers: [{name: left, needs: [Left]}, {name: right, needs: [Right]}]}
  Third: {needs: [First, Second, Left]}
  Left: {}
  Right: {}
)");
  const auto count = [&](const char* name, std::int64_t most) {
    Budget budget;
    return count_plans(test.model, test.provider(name), most, budget);
  };
  CHECK(count("Juggle", 100).plans == 2);
  CHECK(count("Juggle", 100).dead_ends == 2); // both left, both right
  CHECK(count("Juggle", 5).complete);
  CHECK_FALSE(count("Juggle", 4).complete);
  CHECK(count("Juggle", 1).tried() == 1);
  CHECK_FALSE(count("Juggle", 1).complete);
  CHECK(count("Left", 100).plans == 1);
  CHECK(count("Third", 100).plans == 0);
  Budget budget;
  CHECK(find_plan(test.model, test.provider("Third"), budget) == PlanVerdict::none);
  CHECK(find_plan(test.model, test.provider("Juggle"), budget) == PlanVerdict::found);
}

TEST_CASE("a search that takes too long reports that it did not decide") {
  // Twelve tasks that share eleven limbs: pigeons and holes, which no such search finishes.
  std::string text = head + "  All: {needs: [";
  for (int i = 0; i < 12; ++i) text += (i == 0 ? "T" : ", T") + std::to_string(i);
  text += "]}\n";
  for (int i = 0; i < 12; ++i) {
    text += "  T" + std::to_string(i) + ":\n    providers:\n";
    for (int j = 0; j < 11; ++j)
      text += "      - {name: by" + std::to_string(j) + ", needs: [L" + std::to_string(j) + "]}\n";
  }
  for (int j = 0; j < 11; ++j) text += "  L" + std::to_string(j) + ": {}\n";
  const tests::Analysed test(text);
  Budget budget;
  CHECK(find_plan(test.model, test.provider("All"), budget) == PlanVerdict::undecided);
}

TEST_CASE("a group is indispensable if every way leads to it") {
  const tests::Analysed test(head + R"(
  Walk: {needs: [Legs]}
  Legs: {providers: [{name: both, needs: [Left, Right]}, {name: one, needs: [Left]}]}
  Left: {}
  Right: {}
  Loop: {needs: [Loop]}
)");
  const Indispensable indispensable(test.model);
  const auto walk_needs = [&](const char* name) {
    return indispensable.contains(test.group("Walk"), test.group(name));
  };
  CHECK(walk_needs("Walk"));
  CHECK(walk_needs("Legs"));
  CHECK(walk_needs("Left"));
  CHECK_FALSE(walk_needs("Right"));
  CHECK(indispensable.of(test.group("Walk"))->size() == 3);
  CHECK_FALSE(indispensable.of(test.group("Loop")));
}

} // namespace
