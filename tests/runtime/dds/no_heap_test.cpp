// SPDX-License-Identifier: MIT
#include "tests/runtime/dds/robot.hpp"
#include "tests/system/no_heap/heap_trap.hpp"

#include <catch2/catch.hpp>

#include <tuple>

using namespace director::tests;

TEST_CASE("a thread that steps and calls the bridge does not use the heap") {
  Robot one({.robot = "one", .publish = {"Mood", "Battery"}, .say_again = 5ms});
  one.plans.rest = [](courier::Rest::Default& run) { return run.request(courier::Sing{}); };
  one.step();
  const std::size_t before = heap_uses();
  {
    const HeapTrap trap;
    for (int i = 0; i < 2000; ++i) {
      std::ignore = one.behaviour.set(i % 2 == 0 ? post::Mood::calm : post::Mood::hurried, courier::Battery{i % 100});
      i % 3 == 0 ? one.behaviour.request<courier::Rest>() : one.behaviour.cancel<courier::Rest>();
      one.step();
    }
  }
  CHECK(heap_uses() == before);
  CHECK(one.comes_true([&] { return one.bridge.counts().states_said > 0; }));
}
