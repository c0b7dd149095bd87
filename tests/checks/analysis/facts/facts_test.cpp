#include "compiler/checks/analysis/facts/facts.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::checks;

struct Found {
  tests::Compiled compiled;
  Facts facts;
  explicit Found(const std::string& text)
      : compiled(tests::compile("behaviour: test\nlanguage: 1\n" + text)),
        facts(find_facts(compiled.model, make_graph(compiled.model))) {}
  /// The providers that may be active.
  std::string active() const { return names(facts.active); }
  std::string pushed() const { return names(facts.pushed); }

private:
  std::string names(const IdSet<ProviderId>& set) const {
    std::string out;
    for (const ProviderId id : compiled.model.providers.ids()) {
      if (set.contains(id)) out += compiled.model.full_name(id) + " ";
    }
    return out;
  }
};

const std::string walker = R"(
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
  const Found found(walker + "roots: {Walk: {priority: 1}, Kick: {priority: 2}}\n");
  CHECK(found.active() == "Walk.walking Walk.halting Kick Legs Ball ");
  CHECK(found.pushed() == "Walk.halting ");
}

TEST_CASE("a weaker task pushes nothing and never runs") {
  const Found found(walker + "roots: {Walk: {priority: 2}, Kick: {priority: 1}}\n");
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

TEST_CASE("what is reported as impossible is taken for mended") {
  const Found found("states: {A: {values: [no, yes], initial: no}}\nroots: [Kick]\ngroups: {Kick: {when: [A == yes], "
                    "tasks: [Ball]}, Ball: {}}\n");
  CHECK(found.facts.impossible.size() == 1);
  CHECK(found.facts.impossible[0].why == Impossible::Why::unreachable);
  CHECK(found.active() == "Kick Ball ");
}

} // namespace
