#pragma once
// SPDX-License-Identifier: MIT
// Shape: the whole program, for a deployment whose legs are `Legs`: the world and the player step a hundred times a
// second, and a timeline tells what the engine decides. Errors: exit codes; 2 is wrong usage.

#include "behaviours/soccer/arguments.hpp"
#include "behaviours/soccer/live.hpp"
#include "behaviours/soccer/player/player.hpp"
#include "behaviours/soccer/timeline/timeline.hpp"

#include "runtime/hosted/trace/recorder.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>

/// One observer for all.
template <class Live>
struct Listeners {
  director::Observer timeline;
  director::Recorder* recorder = nullptr; ///< null: nothing is recorded
  Live* live = nullptr;                   ///< null: nobody can look

  director::Observer observer() {
    if (recorder == nullptr && live == nullptr) return timeline;
    return {[](void* self, const director::Event& event) {
              const auto& all = *static_cast<Listeners*>(self);
              if (all.recorder != nullptr) all.recorder->tell(event);
              if (all.live != nullptr) all.live->tell(event);
              all.timeline.tell(all.timeline.self, event);
            },
            this};
  }
};

/// `html`: the page about the behaviour, for a browser.
template <class Legs>
int play(const Arguments& arguments, std::string_view html) {
  const bool colours = isatty(STDOUT_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr;
  namespace names = soccer::names;
  Timeline timeline{{names::group, names::provider, names::state, names::condition, names::value},
                    Page{stdout, colours}};
  sim::World world{arguments.seed};
  std::string problem;
  const auto live = live_view(arguments, html, problem);
  if (!problem.empty()) std::fprintf(stderr, "soccer: %s\n", problem.c_str());
  if (!problem.empty()) return 2;
  if (live) std::printf("Live: %s\n\n", live->url().c_str()), std::fflush(stdout);
  std::unique_ptr<director::Recorder> recorder;
  if (!arguments.trace.empty())
    recorder = std::make_unique<director::Recorder>(
      names::all(), arguments.trace, director::Recorder::Options{.waits = true}); // the world waits as well
  Listeners listeners{timeline.observer(), recorder.get(), live.get()};
  player::Player<Legs> player{world, listeners.observer()};
  timeline.tell_of(player.behaviour().engine().tables());
  const Pace pace{arguments.speed};
  int steps = 0;
  for (; world.now() < arguments.seconds * 1000 && stopping() == 0; ++steps) {
    world.step();
    player.step();
    if (live) live->show(player.behaviour());
    if (arguments.speed) std::fflush(stdout);
    pace.wait_for(world.now());
  }
  timeline.finish();

  const Counts& counts = timeline.counts();
  std::printf("\nA game of %d s, seed %llu: %d kicks, %d goals.\n", world.now() / 1000,
              static_cast<unsigned long long>(arguments.seed), world.kicks(), world.goals());
  std::printf("%d runs, %d pushes, %d take-overs, %d hand-overs without a stop, %d steps.\n", counts.runs,
              counts.pushes, counts.take_overs, counts.hand_overs, steps);
  if (recorder) {
    recorder->close(); // what waits may find the disk full
    const int error = recorder->error();
    if (error != 0) std::fprintf(stderr, "soccer: %s cannot be written: %s\n", arguments.trace.c_str(), std::strerror(error));
    if (error != 0) return 2;
  }
  return counts.faults == 0 ? 0 : 1;
}

template <class Legs>
int program(int count, char** values, std::string_view html) {
  const CommandLine command = parse({values + 1, values + count});
  if (command.play) return play<Legs>(*command.play, html);
  std::fputs(command.text.c_str(), command.exit_code == 0 ? stdout : stderr);
  return command.exit_code;
}
