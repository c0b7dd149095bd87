// A game without observer, in which nothing of the behaviour, its bodies or the engine may allocate. A program of its
// own, because the trap stands between everybody and malloc; operator new comes by there too.
#include "behaviours/soccer/player/player.hpp"
#include "behaviours/soccer/player/servos.hpp"
#include "tests/no_heap/heap_trap.hpp"

#include <cstdio>

using director::tests::heap_uses;
using director::tests::HeapTrap;

int main() {
  int* volatile probe = nullptr;
  {
    const HeapTrap trap;
    probe = new int(1);
  }
  delete probe;
  if (heap_uses() != 1) return std::puts("the trap does not catch operator new"), 1;

  sim::World world{1};
  player::Player<player::Servos> player{world};
  while (world.now() < 60'000) {
    world.step();
    const HeapTrap trap;
    player.step();
  }
  const std::size_t allocations = heap_uses() - 1; // without the probe
  std::printf("%d kicks, %d goals, %zu allocations\n", world.kicks(), world.goals(), allocations);
  return allocations == 0 && world.kicks() > 0 ? 0 : 1;
}
