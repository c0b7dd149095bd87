// SPDX-License-Identifier: MIT
// The engine uses no heap: every scenario of the project is played with the heap watched inside of Engine::take_step,
// but not inside of the scripted bodies and of the recorder, which are not the robot's. The linker inserts the
// functions below between the player of scenarios and the engine (--wrap, see CMakeLists.txt).

#include "compiler/lower/lower.hpp"
#include "compiler/model/resolve/resolve.hpp"
#include "compiler/play/play.hpp"
#include "compiler/play/scenario/resolve_scenario.hpp"
#include "compiler/play/scripted_bodies.hpp"
#include "dsl/reading/read_behaviour.hpp"
#include "dsl/reading/read_scenario.hpp"
#include "runtime/core/engine/engine.hpp"
#include "tests/support/golden.hpp"
#include "tests/system/no_heap/heap_trap.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <new>
#include <vector>

namespace {

using namespace director;

Bodies scripted;
Observer observer;
std::size_t watched_steps = 0, watched_players = 0;

} // namespace

// The asm labels are the names that the compilers give to Engine::take_step(Time), ScriptedBodies::table() and
// EventConverter::observer(), as the linker's --wrap names the original and the replacement.
StepResult real_step(Engine* engine, Time now) __asm__("__real__ZN8director6Engine9take_stepEl");
Bodies real_table(compiler::ScriptedBodies* self) __asm__("__real__ZN8director8compiler14ScriptedBodies5tableEv");
Observer real_observer(compiler::EventConverter* self) __asm__("__real__ZN8director8compiler14EventConverter8observerEv");
StepResult watched_step(Engine* engine, Time now) __asm__("__wrap__ZN8director6Engine9take_stepEl");
Bodies watched_table(compiler::ScriptedBodies* self) __asm__("__wrap__ZN8director8compiler14ScriptedBodies5tableEv");
Observer watched_observer(compiler::EventConverter* self) __asm__("__wrap__ZN8director8compiler14EventConverter8observerEv");

StepResult watched_step(Engine* engine, Time now) {
  ++watched_steps;
  const tests::HeapTrap trap;
  return real_step(engine, now);
}

Bodies watched_table(compiler::ScriptedBodies* self) {
  ++watched_players;
  scripted = real_table(self);
  Bodies watched = scripted;
  watched.run = [](void* bodies, Run& context) {
    const tests::Amnesty amnesty;
    return scripted.run(bodies, context);
  };
  watched.start = [](void* bodies, Handling& context) {
    const tests::Amnesty amnesty;
    scripted.start(bodies, context);
  };
  watched.stop = [](void* bodies, Handling& context) {
    const tests::Amnesty amnesty;
    scripted.stop(bodies, context);
  };
  watched.data = [](void* bodies, Bodies::Data what, Index edge, Index handle) {
    const tests::Amnesty amnesty;
    scripted.data(bodies, what, edge, handle);
  };
  return watched;
}

Observer watched_observer(compiler::EventConverter* self) {
  ++watched_players;
  observer = real_observer(self);
  return {[](void* recorder, const Event& event) {
            const tests::Amnesty amnesty;
            observer.tell(recorder, event);
          },
          observer.self};
}

namespace director::tests {
namespace {

std::vector<std::string> scenarios() {
  std::vector<std::string> paths;
  for (const char* folder : {"tests/conformance", "behaviours"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source_dir() / folder)) {
      const std::string path = entry.path().string();
      if (path.ends_with(".scenario.yaml") && path.find("/refused/") == std::string::npos) paths.push_back(path);
    }
  }
  return paths;
}

void play_file(const std::string& path) {
  dsl::DiskFiles disk;
  dsl::Sources sources;
  const dsl::ReadScenarioResult read = dsl::read_scenario(path, disk, sources);
  const std::string behaviour = (std::filesystem::path(path).parent_path() / read.scenario.behaviour.value).string();
  const dsl::ReadResult spec = dsl::read_behaviour(behaviour, disk, sources);
  const compiler::Resolved resolved = compiler::resolve(spec.spec, sources);
  const compiler::Lowered lowered = compiler::lower(resolved.model);
  const compiler::ResolvedScenario scenario = compiler::resolve_scenario(read.scenario, resolved.model);
  REQUIRE(scenario.findings.empty());
  std::size_t events = 0;
  compiler::play(scenario.scenario, resolved.model, lowered, {true}, [&](const compiler::Happening&) { ++events; });
  CHECK(events > 0);
}

TEST_CASE("the trap counts requests to the heap, and only while it is armed") {
  const auto ask = [] { // a compiler may remove unused allocations
    static void* volatile kept = nullptr;
    kept = ::operator new(100);
    ::operator delete(kept);
    kept = std::malloc(100);
    std::free(kept);
  };
  const std::size_t before = heap_uses();
  ask();
  CHECK(heap_uses() == before);
  {
    const HeapTrap trap;
    ask();
  }
  CHECK(heap_uses() == before + 2);
}

TEST_CASE("no scenario makes the engine use the heap") {
  const std::vector<std::string> paths = scenarios();
  CHECK(paths.size() >= 80);
  for (const std::string& path : paths) {
    INFO(path);
    const std::size_t before = heap_uses(), steps = watched_steps, players = watched_players;
    play_file(path);
    REQUIRE(watched_players ==
            players + 2); // otherwise the linker found these functions where they are called, in one source
    CHECK(heap_uses() == before);
    CHECK(watched_steps > steps);
  }
}

} // namespace
} // namespace director::tests
