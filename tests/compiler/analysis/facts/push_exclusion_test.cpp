// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/push_exclusion.hpp"
#include "tests/compiler/analysis/support/analysed.hpp"

#include <catch2/catch.hpp>

#include <string>

namespace {

using namespace director;
using namespace director::analysis;

const std::string begin = "states:\n"
                          "  Estop: {values: [pressed, clear, unknown], initial: clear, external: true}\n"
                          "  Mode: {values: [manual, automatic], initial: manual}\n"
                          "  Motion: {values: [still, rolling], initial: rolling}\n"
                          "roots: {Freeze: {priority: 20}, Drive: {priority: 10}}\ngroups:\n";

/// The state that keeps `Freeze` from pushing `Drive.braking`, if it is one that only the outside changes in capitals;
/// the keys of the two, and further groups.
std::string excluding(const std::string& freeze, const std::string& braking, const std::string& groups = {}) {
  const tests::Analysed test(begin + "  Freeze: {" + freeze + "}\n  Drive: {providers: [{name: braking, " + braking +
                             ", causing: [Motion == still]}, {name: rolling}]}\n" + groups);
  const Causers causers = find_causers(test.model);
  const PushExclusion exclusion(test.model, test.facts, causers);
  const ProviderId waiter = test.provider("Freeze"), causer = test.provider("Drive.braking");
  const std::optional<StateId> state = exclusion.find(waiter, causer);
  if (!state) return {};
  const std::string name = test.model.states[*state].name.value;
  return exclusion.find_outside(waiter, causer) == state ? name + ", from outside" : name;
}

TEST_CASE("a task never pushes what runs only with other values of a state that nothing causes") {
  CHECK(excluding("when: [Estop == pressed, Motion == still]", "when: [Estop == clear]") == "Estop, from outside");
  CHECK(excluding("when: [Estop != clear, Estop != unknown, Motion == still]", "when: [Estop == clear|unknown]") ==
        "Estop, from outside");
  CHECK(excluding("when: [Estop == pressed, Motion == still]", "when: [Estop != clear]") == "");
}

TEST_CASE("a state that a provider sets excludes a push too, but not for ever") {
  CHECK(excluding("when: [Mode == manual, Motion == still]", "when: [Mode == automatic]",
                  "  Switch: {sets: [Mode]}\n") == "Mode");
}

TEST_CASE("what a provider causes can be pushed for first") {
  CHECK(excluding("when: [Mode == manual, Motion == still]", "when: [Mode == automatic]",
                  "  Switch: {causing: [Mode == automatic]}\n") == "");
}

TEST_CASE("what two providers need without alternative keeps the one from pushing the other") {
  const std::string brake = "  Brake: {when: [Estop == clear]}\n";
  CHECK(excluding("when: [Estop == pressed, Motion == still]", "needs: [Brake]", brake) == "Estop, from outside");
  CHECK(excluding("when: [Motion == still], needs: [Lock]", "needs: [Brake]",
                  brake + "  Lock: {when: [Estop == pressed]}\n") == "Estop, from outside");
  CHECK(excluding("when: [Estop == pressed, Motion == still]", "needs: [Brake]",
                  "  Brake: {providers: [{name: soft, when: [Estop == clear]}, {name: hard}]}\n") == "");
}

TEST_CASE("a provider that runs already may stay where it could not begin") {
  CHECK(excluding("when: [Estop == pressed, Motion == still]", "when: [Estop == clear], stay: [Estop != unknown]") ==
        "");
  CHECK(excluding("when: [Estop == pressed, Motion == still], stay: [Estop == clear]", "when: [Estop == clear]") ==
        "Estop, from outside");
}

TEST_CASE("where tasks exist only with some values of a state, these keep the one from pushing the other") {
  const tests::Analysed test(begin + "  Freeze: {when: [Motion == still]}\n"
                                     "  Drive: {providers: [{name: braking, causing: [Motion == still]}, "
                                     "{name: steering, when: [Estop == clear]}]}\n");
  const Causers causers = find_causers(test.model);
  const PushExclusion exclusion(test.model, test.facts, causers);
  const ProviderId waiter = test.provider("Freeze"), braking = test.provider("Drive.braking");
  const auto with = [&](const char* name, int value) {
    Region out;
    out.meet(test.state(name), ValueSet::single(value));
    return out;
  };
  CHECK(exclusion.find_outside(waiter, with("Estop", 0), braking, with("Estop", 1)) == test.state("Estop"));
  CHECK_FALSE(exclusion.find_outside(waiter, with("Estop", 0), braking, with("Estop", 0)));
  CHECK_FALSE(exclusion.find_outside(waiter, with("Estop", 0), braking, {}));
  CHECK(exclusion.find_outside(waiter, with("Estop", 0), test.provider("Drive.steering"), {}) == test.state("Estop"));
  CHECK_FALSE(exclusion.find_outside(waiter, with("Motion", 0), braking, with("Motion", 1)));
}

} // namespace
