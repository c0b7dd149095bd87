// SPDX-License-Identifier: MIT
#include "tests/compiler/explore/environment/ground_words.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <algorithm>

using namespace director::compiler;
using director::tests::packs;
using director::tests::puts;

TEST_CASE("a range counts as the intervals that conditions cut") {
  const auto compiled = director::tests::compile(R"(behaviour: b
language: 1
states: {Charge: {range: [0, 100], external: true}}
roots: [A]
groups: {A: {providers: [{name: x, when: [Charge > 50]}, {name: y, when: [Charge > 10, Charge != 70]}]}}
)");
  const Ground ground(compiled.model);
  const ValueClasses& classes = ground.classes[0];
  CHECK(classes.count() == 4);
  CHECK(classes.of(0) == classes.of(10));
  CHECK(classes.of(10) != classes.of(11));
  CHECK(classes.of(51) == classes.of(100));
  CHECK(classes.of(70) != classes.of(71));
  CHECK(classes.of(director::unset) == 4);
  CHECK(puts(ground, ground.sets) == "Charge=0 |Charge=11 |Charge=51 |Charge=70 |");
}

TEST_CASE("flat tasks are requested in every subset, packs whole, both at each level") {
  const auto compiled = director::tests::compile(R"(behaviour: b
language: 1
roots: [A, P]
groups:
  A: {tasks: {B: {}, C: {priority: {low: 1, high: 2}}}}
  P: {packs: {both: {B: {}, C: {priority: {low: 1, high: 2}}}, none: {}}}
  B: {}
  C: {}
)");
  const Ground ground(compiled.model);
  CHECK(packs(ground, 0) == "B C |C |B C:1 |C:1 |B ||");
  CHECK(packs(ground, 1) == "B C |B C:1 ||");
  CHECK(packs(ground, 2) == "|");
}

TEST_CASE("a body may leave out each optional entry of a pack") {
  const auto compiled = director::tests::compile(R"(behaviour: b
language: 1
roots: [P]
groups:
  P: {packs: {all: {A: {}, B: {optional: true}, C: {optional: true}}}}
  A: {}
  B: {}
  C: {}
)");
  const Ground ground(compiled.model);
  CHECK(packs(ground, 0) == "A B C |A C |A B |A |");
  CHECK(ground.narrowed.empty());
}

TEST_CASE("of more than eight flat tasks not every subset is tried") {
  std::string behaviour = "behaviour: b\nlanguage: 1\nroots: [P]\ngroups:\n  P: {tasks: [A, B, C, D, E, F, G, H, K]}\n";
  for (const char group : std::string("ABCDEFGHK")) behaviour += std::string("  ") + group + ": {}\n";
  const auto compiled = director::tests::compile(behaviour);
  const Ground ground(compiled.model);
  CHECK(packs(ground, 0) == "A B C D E F G H K ||A |B |C |D |E |F |G |H |K |");
  const std::string words = "a body that requests several, but not all, of the tasks of P, which has too many ways";
  CHECK(ground.narrowed == std::vector{words});
  CHECK(std::count(ground.left_out.begin(), ground.left_out.end(), words) == 1);
}

TEST_CASE("of many external states, or root tasks, not every combination is one input") {
  std::string behaviour = "behaviour: b\nlanguage: 1\nstates:\n";
  for (const char state : std::string("STUVWX"))
    behaviour += std::string("  ") + state + ": {values: [low, high], initial: low, external: true}\n";
  behaviour += "roots: [A, B, C, D, E, F, G, H, K]\ngroups:\n"
               "  A: {when: [S == low, T == low, U == low, V == low, W == low, X == low]}\n";
  for (const char group : std::string("BCDEFGHK")) behaviour += std::string("  ") + group + ": {}\n";
  const auto compiled = director::tests::compile(behaviour);
  CHECK(Ground(compiled.model).narrowed ==
        std::vector<std::string>{"several root tasks in one input (they are queued one after another)",
                                 "several states that are set in one input (they are queued one after another)"});
}

TEST_CASE("a body usually keeps its promise and sets nothing else") {
  const auto compiled = director::tests::compile(R"(behaviour: b
language: 1
states:
  X: {values: [a, b, c], initial: a}
  Y: {values: [off, on], initial: off}
roots: [W]
groups:
  W:
    when: [Y == on]
    causing: [X > a]
    sets: [Y == off]
    stop: {sets: [Y]}
    tasks: [V]
  V: {when: [X == b]}
)");
  const Ground ground(compiled.model);
  CHECK(puts(ground, ground.bodies[0].puts) == "X=c |X=b ||X=c Y=off |X=b Y=off |Y=off |");
  CHECK(puts(ground, ground.stopping[0]) == "Y=off |Y=on ||");
}
