// SPDX-License-Identifier: MIT
#include "compiler/analysis/states/covering.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

#include <random>

namespace {

using namespace director;
using namespace director::analysis;

/// States S0, S1, ... with so many values each, every other one unset at first.
std::string some_states(std::size_t count, std::size_t values) {
  std::string out = "states:\n";
  for (std::size_t i = 0; i < count; ++i)
    out += "  S" + std::to_string(i) + ": {range: [0, " + std::to_string(values - 1) + "], external: true" +
           (i % 2 == 0 ? ", initial: 0}\n" : "}\n");
  return out + "roots: []\n";
}

struct Space {
  tests::Analysed test;
  IdTable<StateId, ValueSet> values;

  Space(std::size_t count, std::size_t each) : test(some_states(count, each)), values(count) {
    for (const StateId id : test.model.states.ids()) values[id] = test.model.states[id].domain();
  }

  Covering cover(const std::vector<Region>& regions, Budget& budget, Box* opening = nullptr) const {
    return find_covering(test.model, values, Box{}, regions, budget, opening);
  }

  /// The same by testing every place.
  bool is_open(const std::vector<Region>& regions) const {
    std::vector<std::int64_t> place; // one above the highest value: unset
    for (const StateId id : test.model.states.ids()) place.push_back(test.model.states[id].low);
    while (true) {
      if (std::none_of(regions.begin(), regions.end(), [&](const Region& region) {
            return std::all_of(region.states.begin(), region.states.end(),
                               [&](const auto& entry) { return entry.second.contains(place[entry.first.value]); });
          }))
        return true;
      std::size_t at = 0;
      for (; at < place.size(); ++at) {
        const compiler::State& state = test.model.states[StateId{static_cast<std::uint32_t>(at)}];
        if (++place[at] <= state.high + (state.may_be_unset() ? 1 : 0)) break;
        place[at] = state.low;
      }
      if (at == place.size()) return false;
    }
  }
};

std::uint32_t below(std::mt19937& random, std::uint32_t end) { return static_cast<std::uint32_t>(random() % end); }

Region random_region(std::mt19937& random, std::uint32_t count, std::uint32_t values, std::uint32_t conditions) {
  Region out;
  for (std::uint32_t i = 0; i < conditions; ++i) {
    ValueSet accepted;
    for (std::uint32_t value = 0; value < values; ++value) {
      if (below(random, 4) != 0) accepted = accepted.united(ValueSet::single(value));
    }
    out.meet(StateId{below(random, count)}, accepted);
  }
  return out;
}

TEST_CASE("regions that restrict one and the same state are one region") {
  const Space space(2, 10'000);
  std::vector<Region> stairs;
  for (std::int64_t i = 1; i < 2'000; ++i) stairs.emplace_back().meet(StateId{0}, ValueSet::interval(0, 5 * i));
  Budget budget(10), budget_of_all(10);
  Box opening;
  CHECK(space.cover(stairs, budget, &opening) == Covering::open);
  CHECK(opening[StateId{0}] == Possible{ValueSet::interval(9'996, 9'999), false});
  stairs.emplace_back().meet(StateId{0}, ValueSet::interval(9'000, 9'999));
  CHECK(space.cover(stairs, budget_of_all) == Covering::covered);
  CHECK_FALSE(budget.exhausted());
  CHECK_FALSE(budget_of_all.exhausted());
}

TEST_CASE("what is prepared for a search counts as a part of it") {
  const Space space(3, 10'000);
  std::vector<Region> boxes(1);
  ValueSet even;
  for (std::int64_t i = 0; i < 5'000; ++i) even.add_last({2 * i, 2 * i});
  boxes.front().meet(StateId{0}, even);
  for (std::int64_t i = 0; i < 600; ++i) {
    Region& box = boxes.emplace_back();
    box.meet(StateId{0}, ValueSet::single(2 * i));
    box.meet(StateId{2}, ValueSet::single(2 * i));
  }
  Budget enough, little(0);
  CHECK(space.cover(boxes, enough) == Covering::open);
  CHECK(space.cover(boxes, little) == Covering::undecided);
}

TEST_CASE("what is reported as covered, and what is open, is so at every place") {
  std::mt19937 random(1);
  int open = 0;
  for (int round = 0; round < 600; ++round) {
    const std::uint32_t count = 1 + below(random, 4), values = 1 + below(random, 4);
    const Space space(count, values);
    std::vector<Region> regions;
    for (std::uint32_t i = below(random, 24); i > 0; --i)
      regions.push_back(random_region(random, count, values, 1 + below(random, 3)));
    Budget budget;
    Box opening;
    const Covering found = space.cover(regions, budget, &opening);
    CAPTURE(round);
    REQUIRE(found == (space.is_open(regions) ? Covering::open : Covering::covered));
    if (found == Covering::covered) continue;
    ++open;
    for (const Region& region : regions) {
      const bool apart = std::any_of(region.states.begin(), region.states.end(), [&](const auto& entry) {
        const auto at = opening.find(entry.first);
        return !(at == opening.end() ? space.values[entry.first] : at->second.values).overlaps(entry.second);
      });
      REQUIRE(apart);
    }
  }
  CHECK(open > 100);
  CHECK(open < 500);
}

TEST_CASE("an opening is as wide as it can be") {
  const Space space(3, 4);
  Region first, second;
  first.meet(StateId{0}, ValueSet::interval(0, 1));
  second.meet(StateId{0}, ValueSet::interval(0, 3));
  second.meet(StateId{2}, ValueSet::interval(1, 2));
  Budget budget;
  Box opening;
  REQUIRE(space.cover({first, second}, budget, &opening) == Covering::open);
  CHECK(opening == Box{{StateId{0}, {ValueSet::interval(2, 3), false}},
                       {StateId{2}, {ValueSet::single(0).united(ValueSet::single(3)), false}}});
}

/// `pigeons` states, each with a value for each hole; a region wherever two of them are in one hole.
std::vector<Region> pigeons_and_holes(std::uint32_t pigeons, std::int64_t holes) {
  std::vector<Region> out;
  for (std::uint32_t a = 0; a < pigeons; ++a) {
    for (std::uint32_t b = 0; b < a; ++b) {
      for (std::int64_t hole = 0; hole < holes; ++hole) {
        Region both;
        both.meet(StateId{2 * a}, ValueSet::single(hole));
        both.meet(StateId{2 * b}, ValueSet::single(hole));
        out.push_back(std::move(both));
      }
    }
  }
  return out;
}

TEST_CASE("a question that is too hard is left open, in the same way every time") {
  const Space space(26, 12);
  Budget budget, again;
  CHECK(space.cover(pigeons_and_holes(13, 12), budget) == Covering::undecided);
  CHECK(space.cover(pigeons_and_holes(13, 12), again) == Covering::undecided);
  CHECK(budget.grant(Budget::of_a_run) == again.grant(Budget::of_a_run));
  CHECK(budget.grant(Budget::of_a_run) < Budget::of_a_run);
}

TEST_CASE("behind hard questions the easy ones are answered too") {
  const Space space(26, 12);
  Budget budget(0);
  CHECK(space.cover(pigeons_and_holes(13, 12), budget) == Covering::undecided);
  CHECK(space.cover(pigeons_and_holes(3, 2), budget) == Covering::open);
  Region all;
  all.meet(StateId{0}, ValueSet::interval(0, 11));
  CHECK(space.cover({all}, budget) == Covering::covered);
}

} // namespace
