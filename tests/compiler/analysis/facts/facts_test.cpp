// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/facts.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

struct Found : tests::Analysed {
  using Analysed::Analysed;
  /// The providers that may be active.
  std::string active() const { return names(facts.active); }
  std::string pushed() const { return names(facts.pushed); }
};

const std::string walk_and_kick = R"(
states: {Pose: {values: [moving, standing], initial: moving}}
groups:
  Walk:
    providers:
      - {name: walking, sets: [Pose == moving], tasks: [Legs]}
      - {name: halting, causing: [Pose == standing], tasks: [Legs]}
  Kick: {when: [Pose == standing], tasks: [Ball]}
  Legs: {}
  Ball: {}
)";

TEST_CASE("a stronger task pushes what it waits for, and then runs with what is below it") {
  const Found found(walk_and_kick + "roots: {Walk: {priority: 1}, Kick: {priority: 2}}\n");
  CHECK(found.active() == "Walk.walking Walk.halting Kick Legs Ball ");
  CHECK(found.pushed() == "Walk.halting ");
}

TEST_CASE("a weaker task pushes nothing and never runs") {
  const Found found(walk_and_kick + "roots: {Walk: {priority: 2}, Kick: {priority: 1}}\n");
  CHECK(found.active() == "Walk.walking Legs ");
  CHECK(found.pushed().empty());
  CHECK_FALSE(found.facts.requested.contains(found.compiled.group("Ball")));
}

TEST_CASE("a chain of pushes is followed to its beginning") {
  const Found found(R"(
states:
  A: {values: [no, yes], initial: no}
  B: {values: [no, yes], initial: no}
roots: {Top: {priority: 3}, X: {priority: 2}, Y: {priority: 1}}
groups:
  Top: {when: [A == yes]}
  X: {providers: [{name: idle}, {name: give, when: [B == yes], causing: [A == yes]}]}
  Y: {providers: [{name: idle}, {name: give, causing: [B == yes]}]}
)");
  CHECK(found.active() == "Top X.idle X.give Y.idle Y.give ");
}

TEST_CASE("a push that could never be completed is not begun") {
  const Found found(R"(
states:
  A: {values: [no, yes], initial: no}
  B: {values: [no, yes], initial: no}
  C: {values: [no, yes], initial: no}
roots: {Top: {priority: 3}, X: {priority: 2}, Z: {priority: 9}}
groups:
  Top: {when: [A == yes, C == yes]}
  X: {providers: [{name: idle}, {name: give, causing: [A == yes]}]}
  Z: {providers: [{name: idle}, {name: give, causing: [C == yes]}]}
)");
  CHECK(found.active() == "X.idle Z.idle ");
}

TEST_CASE("handlers set what they set only where their group may run") {
  const std::string text = R"(
states: {A: {values: [no, yes], initial: no}}
groups:
  Walk: {stop: {sets: [A == yes]}}
  Kick: {when: [A == yes]}
)";
  CHECK(Found(text + "roots: {Kick: {priority: 1}, Walk: {priority: 2}}\n").active() == "Walk Kick ");
  CHECK(Found(text + "roots: [Kick]\n").active().empty());
}

TEST_CASE("what is reported as impossible is treated as corrected") {
  const Found found("states: {A: {values: [no, yes], initial: no}}\nroots: [Kick]\ngroups: {Kick: {when: [A == yes], "
                    "tasks: [Ball]}, Ball: {}}\n");
  CHECK(found.facts.impossible.size() == 1);
  CHECK(found.facts.impossible[0].why == Impossible::Why::unreachable);
  CHECK(found.active() == "Kick Ball ");
}

const std::string ladder = R"(
states: {A: {values: [u, v], initial: u}, B: {values: [u, v], initial: u}}
groups:
  First: {providers: [{name: idle}, {name: acting, causing: [A == v]}]}
  Second: {providers: [{name: idle}, {name: acting, when: [A == v], causing: [B == v]}]}
  Early: {when: [A == v]}
  Late: {when: [B == v]}
)";

TEST_CASE("a chain of pushes is found from its far end, even if a part of it was found before") {
  const std::string second = "First: {priority: 1}, Second: {priority: 2}, ", late = "Late: {priority: 4}";
  const std::string both = "First.acting Second.acting ";
  CHECK(Found(ladder + "roots: {" + second + late + "}\n").pushed() == both);
  CHECK(Found(ladder + "roots: {" + second + "Early: {priority: 3}, " + late + "}\n").pushed() == both);
  const Found found(ladder + "roots: {" + second + "Early: {priority: 9}, " + late + "}\n");
  CHECK(found.pushed() == both);
  CHECK(found.active() == "First.idle First.acting Second.idle Second.acting Early Late ");
}

TEST_CASE("a task that goes before one link of a chain and not before the next pushes neither") {
  const Found alone(ladder + "roots: {First: {priority: 9}, Second: {priority: 1}, Late: {priority: 5}}\n");
  CHECK(alone.pushed() == "");
  CHECK(alone.active() == "First.idle Second.idle ");
  // Another provider may cause the first link, and then the second one can be pushed.
  const Found helped(ladder + "roots: {First: {priority: 8}, Early: {priority: 9}, Second: {priority: 1}, "
                              "Late: {priority: 5}}\n");
  CHECK(helped.pushed() == "First.acting Second.acting ");
}

} // namespace
