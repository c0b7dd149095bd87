// SPDX-License-Identifier: MIT
// The numbers of small behaviours, counted by hand. That no engine does more: tests/property/property_test.cpp, for random behaviours.
#include "compiler/analysis/plans/bounds.hpp"
#include "compiler/lower/lower.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

Bounds bounds_of(const std::string& text) {
  const auto compiled = tests::compile("behaviour: test\nlanguage: 1\n" + text);
  return find_bounds(compiled.model, lower(compiled.model).view());
}

/// A member decided alone: all its choices six times, a choice being a provider looked at and a plan found and left.
constexpr std::int64_t alone(std::int64_t providers, std::int64_t plans) { return 6 * (providers + 2 * plans); }

TEST_CASE("one task: its group is placed, its edge decided, and its provider tried") {
  const Bounds bounds = bounds_of("roots: [A]\ngroups: {A: {}}\n");
  CHECK(bounds.work_in_a_pass == 1 + 1 + alone(1, 1));
  CHECK(bounds.work_in_a_micro_step == bounds.work_in_a_pass);
}

TEST_CASE("components add up in a micro-step, and the dearest counts in a pass") {
  const Bounds bounds = bounds_of("roots: [A, B]\ngroups: {A: {}, B: {providers: [{name: one}, {name: two}]}}\n");
  CHECK(bounds.work_in_a_pass == 1 + 1 + alone(2, 2));
  CHECK(bounds.work_in_a_micro_step == bounds.work_in_a_pass + 1 + 1 + alone(1, 1));
}

TEST_CASE("a pack costs its members alone, and together in all combinations of what can collide; a pass is repeated for what has two requesters") {
  const Bounds bounds = bounds_of(R"(
roots: [Both]
groups:
  Both: {tasks: [Left, Right]}
  Left: {providers: [{name: one, needs: [Arm]}, {name: two, needs: [Leg]}]}
  Right: {providers: [{name: one, needs: [Arm]}, {name: two, needs: [Leg]}, {name: three}]}
  Arm: {}
  Leg: {}
)");
  constexpr std::int64_t left = 2 + 2 * 2, right = 3 + 2 * 3; // their choices
  constexpr std::int64_t unit = 2 * (3 * (left + right) + left + 2 * right);
  constexpr std::int64_t edges = 7; // root to Both, to Left and Right, and four needs
  constexpr std::int64_t sweep = 5 + edges + alone(1, 1) + alone(2, 2) + alone(3, 3) + unit;
  CHECK(bounds.work_in_a_pass == (1 + 2) * sweep); // Arm and Leg
}

TEST_CASE("who waits for a condition searches all that may make it true, once more than there are conditions, and once for nothing") {
  const Bounds bounds = bounds_of(R"(
states: {Pose: {values: [a, b], initial: a}, Hat: {values: [off, on], initial: off}}
roots: [A, B, C]
groups:
  A: {when: [Pose == b]}
  B: {providers: [{name: one, when: [Hat == on], causing: [Pose == b]}, {name: two}]}
  C: {providers: [{name: one, causing: [Hat == on]}, {name: two}]}
)");
  constexpr std::int64_t hat = (1 + 2) * 1, pose = (2 + 2) * 2; // conditions and rounds, plans of those who cause them
  static_assert(hat < pose);
  // A and B each lack one condition, and the dearest search counts.
  CHECK(bounds.work_in_a_pass == 3 + 3 + alone(1, 1) + 2 * alone(2, 2) + 2 * pose);
}

} // namespace
