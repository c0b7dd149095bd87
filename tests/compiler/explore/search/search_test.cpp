// SPDX-License-Identifier: MIT
#include "compiler/explore/search/search.hpp"
#include "tests/compiler/explore/explored.hpp"

using namespace director::compiler;
using director::tests::explore_all;

namespace {

const std::string whole_walker = "behaviour: walker\nlanguage: 1\n"
                                 "states: {Pose: {values: [moving, standing], external: true}}\n" +
                                 director::tests::walker_groups;

} // namespace

TEST_CASE("a small behaviour is explored to the end, and on any number of cores alike") {
  const auto compiled = director::tests::compile(whole_walker);
  const Ground ground(compiled.model);
  const Exploration one = explore_all(ground, 100'000, 1), three = explore_all(ground, 100'000, 3);
  CHECK(one.searched.complete);
  CHECK(one.searched.states == one.searched.explored);
  CHECK(one.searched.states > 50);
  CHECK(to_text(one, ground) == to_text(three, ground));
}

TEST_CASE("beyond its bound a search reports that it is not complete") {
  const auto compiled = director::tests::compile(whole_walker);
  const Ground ground(compiled.model);
  SearchOptions options;
  options.bound = 20;
  const Searched searched = search(ground, options);
  CHECK_FALSE(searched.complete);
  CHECK(searched.states >= 20);
  CHECK(searched.explored < searched.states);
}

TEST_CASE("a provider that never runs and a task that waits for ever are named") {
  const auto compiled = director::tests::compile(R"(behaviour: b
language: 1
states: {S: {values: [x, y], initial: x}}
roots: [A]
groups:
  A:
    needs: [L]
    packs: {both: {L: {priority: 2}, B: {priority: 1}}}
  B: {needs: [L], tasks: [L]}
  L: {providers: [{name: here, when: [S == x]}, {name: there, when: [S == y]}]}
)");
  const Ground ground(compiled.model);
  const Exploration exploration = explore_all(ground);
  REQUIRE(exploration.searched.complete);
  CHECK(to_text(exploration, ground).find("Never ran: B, L.here, L.there\n") != std::string::npos);
  CHECK(to_text(exploration, ground).find("Requested for ever: A>B is never granted") != std::string::npos);
}

TEST_CASE("two tasks that undo each other for ever are found, and can be played") {
  const auto compiled = director::tests::compile(R"(behaviour: b
language: 1
states: {S: {values: [x, y], initial: x}}
roots: {A: {priority: 20}, B: {priority: 10}}
groups:
  A: {when: [S == x], stop: {sets: [S == x]}, needs: [L], causing: [S == y], tasks: [L]}
  B: {needs: [L], tasks: [L]}
  L: {}
)");
  const Ground ground(compiled.model);
  const Exploration exploration = explore_all(ground);
  REQUIRE_FALSE(exploration.oscillations.empty());
  CHECK(exploration.oscillations.front().scenario.has_value());
}

TEST_CASE("a cycle is reported although another one goes round in many states") {
  const auto compiled = director::tests::compile(R"(behaviour: b
language: 1
states:
  S: {values: [a, b], initial: a}
  T: {values: [a, b], initial: a}
  X: {values: [a, b], initial: a, external: true}
  Y: {values: [a, b], initial: a, external: true}
  Z: {values: [a, b], initial: a, external: true}
roots: [One, Two, Look]
groups:
  One: {providers: [{name: up, when: [S == a], causing: [S == b]}, {name: down, causing: [S == a]}]}
  Two: {when: [Z == b], tasks: [Flip]}
  Flip: {providers: [{name: up, when: [T == a], causing: [T == b]}, {name: down, causing: [T == a]}]}
  Look: {providers: [{name: first, when: [X == a, Y == a]}, {name: second, when: [X == b, Y == a]}, {name: third}]}
)");
  const Ground ground(compiled.model);
  const std::string text = to_text(explore_all(ground, 100'000), ground);
  for (const std::string groups : {"One.down, One.up", "Flip.down, Flip.up"})
    CHECK(text.find("micro-steps: " + groups + "\n") != std::string::npos);
}
