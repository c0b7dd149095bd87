// A game without observer, in which nothing of the behaviour, its bodies or the engine may allocate. A program of its
// own, because it stands between everybody and malloc; operator new comes by here too.
#include "behaviours/soccer/player/player.hpp"
#include "behaviours/soccer/player/servos.hpp"

#include <cstddef>
#include <cstdio>
#include <cstdlib>

extern "C" {
// glibc's own.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}

namespace {

bool counting = false;
int calls = 0;

} // namespace

extern "C" {
void* malloc(std::size_t size) {
  calls += counting ? 1 : 0;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  calls += counting ? 1 : 0;
  return __libc_calloc(count, size);
}
void* realloc(void* block, std::size_t size) {
  calls += counting ? 1 : 0;
  return __libc_realloc(block, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  calls += counting ? 1 : 0;
  return __libc_memalign(alignment, size);
}
}

int main() {
  counting = true;
  int* volatile probe = new int(1);
  counting = false;
  delete probe;
  if (calls != 1) return std::puts("the trap does not catch operator new"), 1;
  calls = 0;

  sim::World world{1};
  player::Player<player::Servos> player{world};
  while (world.now() < 60'000) {
    world.step();
    counting = true;
    player.step();
    counting = false;
  }
  std::printf("%d kicks, %d goals, %d allocations\n", world.kicks(), world.goals(), calls);
  return calls == 0 && world.kicks() > 0 ? 0 : 1;
}
