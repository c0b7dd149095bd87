// SPDX-License-Identifier: MIT
#include "compiler/analysis/states/region.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

const char* const two_regions = R"(states:
  Pose: {values: [a, b, c], initial: a, external: true}
  Charge: {range: [0, 100], initial: 0, external: true}
roots: [A]
groups:
  A: {when: [Pose != a, Charge > 50], stay: [Charge > 20]}
  B: {when: [Pose == a]}
  C: {when: [Pose == a|b, Pose == b|c]}
  D: {}
)";

TEST_CASE("a region is what conditions leave of each state") {
  const tests::Analysed test(two_regions);
  const auto region = [&](const char* name) {
    return region_of(test.model, test.model.providers[test.provider(name)].when);
  };
  const StateId pose = test.state("Pose");
  CHECK(region("A").states.size() == 2);
  CHECK(region("C").states.at(pose) == ValueSet::single(1));
  CHECK(region("D").states.empty());
  CHECK_FALSE(region("C").empty());
  CHECK_FALSE(compatible(region("A"), region("B")));
  CHECK(compatible(region("A"), region("C")));
  CHECK(compatible(region("B"), region("D")));
  Region both = region("A");
  both.meet(region("B"));
  CHECK(both.empty());
}

TEST_CASE("a hull leaves open what one side leaves open") {
  const tests::Analysed test(two_regions);
  const Region active = active_region(test.model, test.model.providers[test.provider("A")]);
  CHECK(active.states.size() == 1);
  CHECK(active.states.at(test.state("Charge")) == ValueSet::interval(21, 100));
}

} // namespace
