// SPDX-License-Identifier: MIT
// Tests runtime/core/engine/reports.cpp: the events that a replay needs.
#include "runtime/core/engine/engine.hpp"
#include "tests/runtime/core/machine.hpp"

#include <catch2/catch.hpp>

using namespace director;
using namespace director::tests;

namespace {

const std::string rover = R"(
behaviour: rover
language: 1
roots:
  Explore: {}
  Rest: {}
states:
  Motion: {values: [still, rolling], initial: still, expires: {after: 2 s, to: still}}
  Light: {values: [dark, bright], initial: dark, external: true}
groups:
  Explore:
    start: {sets: [Motion]}
    sets: [Motion]
    every: 3 s
  Rest: {}
)";

} // namespace

TEST_CASE("an answer is reported before its consequences, with the values that it sets without a change") {
  Machine machine(rover);
  machine.answers = true;
  machine.handler("Explore.start",
                  [&](Handling& handling) { handling.set(machine.state("Motion"), machine.value("Motion", "still")); });
  machine.body("Explore", [&](Run& run) {
    run.set(machine.state("Motion"), machine.value("Motion", "rolling"));
    return run.reasons().has(Reason::trigger) ? run.keep() : run.pack();
  });
  machine.engine().preset(machine.state("Light"), machine.value("Light", "bright"));
  machine.request("Explore");
  CHECK(machine.step(1'000'000) == Lines{"begin 1000000", "given Light bright", "input at 1000000 of 1000000",
                                         "start Explore", "assign Motion still by Explore", "run Explore new_task",
                                         "answer Explore pack", "assign Motion rolling by Explore",
                                         "set Motion rolling"});
  CHECK(machine.step(4'500'000) == Lines{"input at 3000000 of 4500000", "set Motion still",
                                         "input at 4000000 of 4500000", "run Explore trigger", "answer Explore keep",
                                         "assign Motion rolling by Explore", "set Motion rolling"});
  CHECK(machine.step(4'600'000) == Lines{});
}

TEST_CASE("a cancel of all tasks is reported even if there are none") {
  Machine machine(rover);
  machine.answers = true;
  machine.step();
  Input all;
  all.kind = Input::Kind::cancel;
  all.thing = nil;
  machine.inbox().post({&all, 1});
  CHECK(machine.step() == Lines{"input at 0 of 0 cancel all"});
  machine.request("Rest");
  machine.step();
  machine.inbox().post({&all, 1});
  CHECK(machine.step() == Lines{"input at 0 of 0 cancel all", "input at 0 of 0 cancel Rest"});
}

TEST_CASE("a run that throws is reported as its answer, without the values that it set") {
  Machine machine(rover);
  machine.answers = true;
  machine.body("Explore", [&](Run& run) {
    run.set(machine.state("Motion"), machine.value("Motion", "rolling"));
    return run.fault();
  });
  machine.request("Explore");
  CHECK(machine.step() == Lines{"begin 0", "input at 0 of 0", "start Explore", "run Explore new_task",
                                "answer Explore fault", "fault Explore"});
}
