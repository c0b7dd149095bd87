#pragma once
// SPDX-License-Identifier: MIT
// Shape: the whole program, for a deployment whose legs are `Legs`: the world and the player step a hundred times a
// second, and a timeline tells what the engine decides. Errors: exit codes; 2 is wrong usage.

#include "behaviours/soccer/arguments.hpp"
#include "behaviours/soccer/player/player.hpp"
#include "behaviours/soccer/timeline/timeline.hpp"

#include "runtime/hosted/trace/recorder.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>

/// One observer for both.
struct Listeners {
  director::Observer timeline;
  director::Recorder* recorder = nullptr; ///< null: nothing is recorded

  director::Observer observer() {
    if (recorder == nullptr) return timeline;
    return {[](void* self, const director::Event& event) {
              const auto& both = *static_cast<Listeners*>(self);
              both.recorder->tell(event);
              both.timeline.tell(both.timeline.self, event);
            },
            this};
  }
};

template <class Legs>
int play(const Arguments& arguments) {
  const bool colours = isatty(STDOUT_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr;
  namespace names = soccer::names;
  Timeline timeline{{names::group, names::provider, names::state, names::condition, names::value},
                    Page{stdout, colours}};
  sim::World world{arguments.seed};
  std::unique_ptr<director::Recorder> recorder;
  if (!arguments.trace.empty())
    recorder = std::make_unique<director::Recorder>(
      names::all(), arguments.trace, director::Recorder::Options{.waits = true}); // the world waits as well
  Listeners listeners{timeline.observer(), recorder.get()};
  player::Player<Legs> player{world, listeners.observer()};
  timeline.tell_of(player.behaviour().engine().tables());
  int steps = 0;
  for (; world.now() < arguments.seconds * 1000; ++steps) {
    world.step();
    player.step();
  }
  timeline.finish();

  const Counts& counts = timeline.counts();
  std::printf("\nA game of %d s, seed %llu: %d kicks, %d goals.\n", arguments.seconds,
              static_cast<unsigned long long>(arguments.seed), world.kicks(), world.goals());
  std::printf("%d runs, %d pushes, %d take-overs, %d hand-overs without a stop, %d steps.\n", counts.runs,
              counts.pushes, counts.take_overs, counts.hand_overs, steps);
  if (recorder) {
    const int error = recorder->error();
    if (error != 0) std::fprintf(stderr, "soccer: %s cannot be written: %s\n", arguments.trace.c_str(), std::strerror(error));
    if (error != 0) return 2;
  }
  return counts.faults == 0 ? 0 : 1;
}

template <class Legs>
int program(int count, char** values) {
  const CommandLine command = parse({values + 1, values + count});
  if (command.play) return play<Legs>(*command.play);
  std::fputs(command.text.c_str(), command.exit_code == 0 ? stdout : stderr);
  return command.exit_code;
}
