// SPDX-License-Identifier: MIT
#include "compiler/analysis/states/choice.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

bool comes_first(const std::string& text, const char* name) {
  const tests::Analysed test(text);
  IdTable<StateId, ValueSet> values(test.model.states.size());
  for (const StateId id : test.model.states.ids()) values[id] = test.model.states[id].domain();
  const ProviderId provider = test.provider(name);
  Budget budget;
  const Region own = region_of(test.model, test.model.providers[provider].when);
  return find_choice(test.model, own, Rivals(test.model, test.facts.holding, test.facts.active).of(provider), values,
                     budget) == Covering::open;
}

const std::string two_states = "states:\n  X: {values: [a, b, c], initial: a, external: true}\n"
                               "  Y: {values: [a, b], external: true}\n";

TEST_CASE("a provider comes first where the earlier ones lack something") {
  CHECK(comes_first(
      two_states + "roots: [G]\ngroups: {G: {providers: [{name: p, when: [X == a]}, {name: q, when: [X != b]}]}}\n",
      "G.q"));
  CHECK_FALSE(comes_first(
      two_states + "roots: [G]\ngroups: {G: {providers: [{name: p, when: [X != b]}, {name: q, when: [X == a]}]}}\n",
      "G.q"));
  CHECK_FALSE(comes_first(two_states + "roots: [G]\ngroups: {G: {providers: [{name: p}, {name: q, when: [X == a]}]}}\n",
                          "G.q"));
}

TEST_CASE("an unset state fails every condition on it") {
  CHECK(comes_first(
      two_states +
          "roots: [G]\ngroups: {G: {providers: [{name: p, when: [Y == a]}, {name: q, when: [Y == b]}, {name: r}]}}\n",
      "G.r"));
  CHECK_FALSE(comes_first(
      two_states +
          "roots: [G]\ngroups: {G: {providers: [{name: p, when: [X == a]}, {name: q, when: [X != a]}, {name: r}]}}\n",
      "G.r"));
}

TEST_CASE("several rivals must all be able to fail at once") {
  const std::string rivals = "{name: p, when: [X == a]}, {name: q, when: [X == b, Y == a]}";
  CHECK_FALSE(comes_first(two_states + "roots: [G]\ngroups: {G: {providers: [" + rivals +
                              ", {name: r, when: [X != c, Y == a]}]}}\n",
                          "G.r"));
  CHECK(comes_first(two_states + "roots: [G]\ngroups: {G: {providers: [" + rivals + ", {name: r, when: [X != c]}]}}\n",
                    "G.r"));
}

TEST_CASE("behind a provider that can always run no provider is a rival") {
  const tests::Analysed test(two_states + "roots: [G]\ngroups: {G: {providers: [{name: p, when: [X == a]}, {name: q}, "
                                          "{name: r, when: [Y == a]}, {name: s}]}}\n");
  const Rivals rivals(test.model, test.facts.holding, test.facts.active);
  const std::vector<Rival> found = rivals.of(test.provider("G.s"));
  REQUIRE(found.size() == 2);
  CHECK(found[0].provider == test.provider("G.p"));
  CHECK(found[1].provider == test.provider("G.q"));
}

TEST_CASE("behind a provider that can run whenever the later one can no provider is a rival") {
  std::string text = "roots: [G, H]\ngroups:\n  L: {}\n  H: {tasks: [L]}\n  G:\n    providers:\n";
  for (int i = 0; i < 1'000; ++i) text += "      - {name: p" + std::to_string(i) + ", needs: [L], tasks: [L]}\n";
  const tests::Analysed test(text);
  const Rivals rivals(test.model, test.facts.holding, test.facts.active);
  for (const char* const later : {"G.p1", "G.p999"}) {
    const std::vector<Rival> found = rivals.of(test.provider(later));
    REQUIRE(found.size() == 1);
    CHECK(found[0].provider == test.provider("G.p0"));
  }
  const auto none_counts = [](const Rival&) { return false; };
  CHECK(rivals.that_meet(test.provider("G.p9"), {}, none_counts).size() == 9);
}

TEST_CASE("a rival whose needs another group may hold can fail") {
  CHECK(comes_first(
      "roots: [G, H]\ngroups: {G: {providers: [{name: p, needs: [L]}, {name: q}]}, H: {tasks: [L]}, L: {}}\n", "G.q"));
  CHECK_FALSE(comes_first(
      "roots: [G]\ngroups: {G: {providers: [{name: p, needs: [L]}, {name: q}]}, H: {tasks: [L]}, L: {}}\n", "G.q"));
  CHECK_FALSE(comes_first("roots: [G, H]\ngroups: {G: {providers: [{name: p, needs: [L]}, {name: q, needs: [L]}]}, H: "
                          "{tasks: [L]}, L: {}}\n",
                          "G.q"));
}

} // namespace
