// SPDX-License-Identifier: MIT
#include "compiler/analysis/chains/meetings.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

struct Ranking : tests::Analysed {
  using Analysed::Analysed;
  bool beats(const char* first, const char* second) const { return chains.may_beat(group(first), group(second)); }
};

TEST_CASE("a root of higher priority and what is below it may push a lower one and what is below that") {
  const Ranking ranking("roots: {High: {priority: 2}, Low: {priority: 1}}\n"
                        "groups: {High: {tasks: [Above]}, Above: {}, Low: {tasks: [Below]}, Below: {}}\n");
  CHECK(ranking.beats("High", "Low"));
  CHECK(ranking.beats("Above", "Below"));
  CHECK_FALSE(ranking.beats("Low", "High"));
  CHECK_FALSE(ranking.beats("Below", "Above"));
  CHECK_FALSE(ranking.beats("High", "Above"));
  CHECK_FALSE(ranking.beats("Above", "High"));
  CHECK_FALSE(ranking.beats("High", "High"));
}

TEST_CASE("equals push nothing of each other") {
  const Ranking ranking("roots: [A, B]\ngroups: {A: {}, B: {}}\n");
  CHECK_FALSE(ranking.beats("A", "B"));
  CHECK_FALSE(ranking.beats("B", "A"));
}

TEST_CASE("an optional edge anywhere on the chain goes after one that has none") {
  const Ranking ranking("roots: {A: {priority: 1}, B: {priority: 9}}\n"
                        "groups: {A: {tasks: [X]}, X: {}, B: {tasks: {Y: {optional: true}, Z: {}}}, Y: {}, Z: {}}\n");
  CHECK(ranking.beats("X", "Y"));
  CHECK_FALSE(ranking.beats("Y", "X"));
  CHECK(ranking.beats("Z", "X"));
}

TEST_CASE("a member of one unit is granted before anything below another one") {
  const Ranking unit("roots: [P]\ngroups: {P: {tasks: {A: {priority: 2}, B: {priority: 1}}}, A: {tasks: [X]}, X: {}, "
                     "B: {tasks: [Y]}, Y: {}}\n");
  CHECK_FALSE(unit.beats("X", "B"));
  CHECK_FALSE(unit.beats("A", "B"));
  CHECK(unit.beats("X", "Y"));
  const Ranking apart("roots: [P]\ngroups: {P: {tasks: {A: {priority: 2}, B: {priority: 1, apart: true}}}, A: {tasks: "
                      "[X]}, X: {}, B: {}}\n");
  CHECK(apart.beats("X", "B"));
  CHECK(apart.beats("A", "B"));
}

TEST_CASE("tasks of different packs never meet") {
  const Ranking ranking(
      "roots: [P]\ngroups: {P: {packs: {one: {A: {priority: 2}}, two: {B: {priority: 1}}}}, A: {}, B: {}}\n");
  CHECK_FALSE(ranking.beats("A", "B"));
}

TEST_CASE("a level that may be requested counts") {
  const Ranking ranking("roots: {A: {priority: {calm: 1, urgent: 9}}, B: {priority: 5}}\ngroups: {A: {}, B: {}}\n");
  CHECK(ranking.beats("A", "B"));
  CHECK(ranking.beats("B", "A"));
}

} // namespace
