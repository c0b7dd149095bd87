// SPDX-License-Identifier: MIT
#include "compiler/model/print_model.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;

TEST_CASE("a model is printed with everything that was decided about it") {
  const auto compiled = tests::compile(R"(behaviour: soccer
language: 1
cpp: {namespace: soccer, headers: [soccer/messages.hpp]}
layers: [skill, limb]
states:
  Stability: {values: [unknown, moving, standing], unordered: [unknown], initial: unknown, external: true}
  Charge: {range: [0, 100], external: true, expires: {after: 2 s, to: 0}}
  Phase: {type: soccer::Phase, values: [ready, playing], external: true, expires: 500 ms}
  Step: {values: [first, second], initial: first, of: Walk}
triggers: [Sensors]
roots:
  Kick: {priority: {normal: 10, urgent: 80}}
  Walk: {priority: 5}
groups:
  Walk:
    layer: skill
    module: locomotion
    data: soccer::WalkCommand
    realtime: true
    start: true
    stop: {sets: [Stability]}
    sets: [Step]
    providers:
      - name: walking
        sets: [Stability == moving]
        triggers: [Sensors, Walk.halting.broken]
        every: 10 ms
        tasks: {Legs: {levels: {firm: {priority: 50}, spare: {priority: 50, optional: true}}}}
      - name: halting
        causing: [Stability == standing within 1 s]
        needs: [Legs]
        uses: [Legs]
        packs: {brake: {Legs: {priority: 7, apart: true}}, rest: {}}
  Kick:
    when: [Stability == standing, Charge > 10, Phase == ready|playing]
    stay: [Stability != unknown]
    needs: [Legs]
  Legs: {layer: limb}
assertions:
  - never_together: [Walk, Kick]
  - beats: {Kick: Walk}
  - can_run: Kick
  - soft: {from: Walk, to: Kick}
limits: {trials: 500, pass: 600}
)");
  CHECK(print_model(compiled.model) == R"(behaviour soccer
namespace soccer
header soccer/messages.hpp
trials 500, in a pass 600
layer skill
layer limb
state Stability: unknown(unordered) moving standing, initial unknown, external
state Charge: 0..100, unset, external, expires after 2000000 us to 0
state Phase: ready playing, type soccer::Phase, unset, external, expires after 500000 us to unset
state Step: first second, initial first, of Walk
trigger Sensors
trigger Walk.halting.broken (a promise)
root Kick (normal = level 0, urgent = level 1)
root Walk (level 0)
module locomotion: Walk
module test: Kick, Legs
group Walk: module locomotion, layer skill, data soccer::WalkCommand, realtime
  start
  stop sets Stability
  provider walking
    sets Step, Stability == moving
    trigger Sensors
    trigger Walk.halting.broken
    every 10000 us
    tasks: Legs (firm = level 0, spare = level 1)
  provider halting
    causing Stability == standing within 1000000 us
    sets Step
    needs Legs
    uses Legs
    pack brake: Legs (level 2)
    pack rest: 
group Kick: module test
  provider default
    when Stability == standing, Charge > 10, Phase == ready|playing
    stay Stability != unknown
    needs Legs
group Legs: module test, layer limb
  provider default
edge root>Kick: 10, 80
edge root>Walk: 5
edge Walk>Legs: 50, 50 optional, 7 apart, needed
edge Kick>Legs: never requested, needed
assert never together Walk, Kick
assert beats Kick, Walk
assert can run Kick
assert soft Walk, Kick
)");
}

} // namespace
