// SPDX-License-Identifier: MIT
#include "compiler/analysis/needs/units.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

struct Tried : tests::Analysed {
  Budget budget;
  Units units{model, facts, budget};
  explicit Tried(const std::string& text) : Analysed("roots: []\n" + text) {}

  std::vector<GroupId> groups(const std::vector<const char*>& names) {
    std::vector<GroupId> out;
    for (const char* name : names) out.push_back(group(name));
    return out;
  }
  UnitVerdict verdict(const std::vector<const char*>& names) { return units.verdict(groups(names)); }
};

TEST_CASE("tasks go together if some choice takes no group twice") {
  Tried tried("groups:\n"
              "  Reach: {providers: [{name: left, needs: [Left]}, {name: right, needs: [Right]}]}\n"
              "  Point: {providers: [{name: left, needs: [Left]}, {name: right, needs: [Right]}]}\n"
              "  Wave: {needs: [Left]}\n  Left: {}\n  Right: {}\n");
  CHECK(tried.verdict({"Reach", "Point"}) == UnitVerdict::possible);
  CHECK(tried.verdict({"Reach", "Wave"}) == UnitVerdict::possible);
  CHECK(tried.verdict({"Reach", "Point", "Wave"}) == UnitVerdict::impossible);
  CHECK(tried.verdict({"Wave", "Left"}) == UnitVerdict::impossible);
  std::size_t count = 0;
  CHECK(tried.units.visit(tried.groups({"Reach", "Point"}), false, [&](const Combination& combination) {
    CHECK(combination.picks.size() == 4);
    return ++count < 100;
  }));
  CHECK(count == 2);
}

TEST_CASE("tasks go together only where their conditions can hold at once") {
  Tried tried("states: {X: {values: [a, b, c], initial: a, external: true}}\ngroups:\n"
              "  A: {when: [X == a]}\n  B: {when: [X == b]}\n"
              "  Both: {providers: [{name: a, when: [X == a]}, {name: b, when: [X == b]}]}\n"
              "  Stays: {when: [X == a], stay: [X == a|b]}\n"
              "  Halting: {when: [X == a], causing: [X == b]}\n");
  CHECK(tried.verdict({"A", "B"}) == UnitVerdict::impossible);
  CHECK(tried.verdict({"A", "Both"}) == UnitVerdict::possible);
  CHECK(tried.verdict({"A", "B", "Both"}) == UnitVerdict::impossible);
  CHECK(tried.verdict({"B", "Stays"}) == UnitVerdict::possible);
  CHECK(tried.verdict({"B", "Halting"}) == UnitVerdict::possible);
  CHECK(tried.units.verdict(tried.groups({"A", "B"}), true) == UnitVerdict::possible);
}

} // namespace
