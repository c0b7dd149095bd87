// SPDX-License-Identifier: MIT
// A whole game of the soccer player, bodies included, uses no heap once it has begun.

#include "behaviours/soccer/player/player.hpp"
#include "behaviours/soccer/player/servos.hpp"
#include "behaviours/soccer/world/world.hpp"
#include "tests/system/no_heap/heap_trap.hpp"

#include <catch2/catch.hpp>

namespace director::tests {
namespace {

struct Count {
  int runs = 0;
};

/// Uses of the heap in a minute of it, without those of the world.
std::size_t heap_uses_in(sim::World& world, auto& player) {
  const std::size_t before = heap_uses();
  while (world.now() < 60'000) {
    world.step();
    const HeapTrap trap;
    player.step();
  }
  return heap_uses() - before;
}

TEST_CASE("a game of soccer uses no heap") {
  sim::World world{1};
  Count count;
  const Observer observer{[](void* self, const Event& event) {
                            if (event.kind == Event::Kind::run) ++static_cast<Count*>(self)->runs;
                          },
                          &count};
  player::Player<player::Servos> player{world, observer};
  CHECK(heap_uses_in(world, player) == 0);
  CHECK(count.runs > 5000);
}

TEST_CASE("a game of soccer without an observer uses no heap") {
  sim::World world{1};
  player::Player<player::Servos> player{world};
  CHECK(heap_uses_in(world, player) == 0);
  CHECK(world.kicks() > 0);
}

} // namespace
} // namespace director::tests
