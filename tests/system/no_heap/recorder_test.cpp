// SPDX-License-Identifier: MIT
// A game of soccer that is recorded uses no heap in the thread that steps, and its bodies decide the same.

#include "behaviours/soccer/player/player.hpp"
#include "behaviours/soccer/player/servos.hpp"
#include "behaviours/soccer/world/world.hpp"
#include "runtime/hosted/trace/recorder.hpp"
#include "tests/support/command.hpp"
#include "tests/support/golden.hpp"
#include "tests/system/no_heap/heap_trap.hpp"

#include <catch2/catch.hpp>

namespace director::tests {
namespace {

TEST_CASE("to record a game of soccer takes no heap from the thread that steps") {
  const TemporaryFolder folder;
  for (const char* name : {"run.jsonl", "run.perfetto-trace"}) {
    const std::size_t before = heap_uses();
    Recorder recorder{soccer::names::all(), (folder.path() / name).string()};
    sim::World world{1};
    player::Player<player::Servos> player{world, recorder.observer()};
    while (world.now() < 20'000) {
      world.step();
      const HeapTrap trap;
      player.step();
    }
    CHECK(heap_uses() == before);
    CHECK(recorder.good());
    CHECK(recorder.dropped() == 0);
  }
  const auto replayed = run_command("directorc replay " + (folder.path() / "run.jsonl").string() +
                                        " --behaviour behaviours/soccer/soccer.yaml",
                                    source_dir());
  CAPTURE(replayed.output);
  CHECK(replayed.output.find("events, all the same\n") != std::string::npos);
}

} // namespace
} // namespace director::tests
