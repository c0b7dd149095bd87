// Header: tests/bench/observing.hpp. Test: tests/bench/CMakeLists.txt.
// SPDX-License-Identifier: MIT
#include "tests/bench/observing.hpp"

#include "behaviours/soccer/player/player.hpp"
#include "runtime/hosted/trace/recorder.hpp"
#include "tests/bench/workload.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <numeric>
#include <thread>

namespace bench {

namespace {

constexpr int replays = 7;
constexpr std::size_t steps = 12'000; ///< two minutes of the game
constexpr std::size_t drained =
    3'000; ///< after this number of steps the recorder, whose queue would be full, has time to write

using Clock = std::chrono::steady_clock;

/// The time of each step of a game with this observer, or the least so far. `pause`: between steps.
void play(const director::Observer& observer, std::vector<double>& least, std::chrono::milliseconds pause = {}) {
  const Workload& soccer = workloads().front();
  const std::unique_ptr<Playing> playing = soccer.make(soccer.size, 1, observer);
  std::size_t step = 0;
  for (double& each : least) {
    if (++step % drained == 0) std::this_thread::sleep_for(pause);
    playing->prepare();
    const Clock::time_point begin = Clock::now();
    playing->take();
    each = std::min(each, std::chrono::duration<double, std::nano>(Clock::now() - begin).count());
  }
}

double total(const std::vector<double>& times) { return std::accumulate(times.begin(), times.end(), 0.0); }

} // namespace

std::vector<Observed> observe() {
  std::vector<double> alone(steps, std::numeric_limits<double>::max());
  std::vector<double> counted = alone, recorded = alone;
  std::uint64_t events = 0, dropped = 0;
  const director::Observer counting{[](void* self, const director::Event&) { ++*static_cast<std::uint64_t*>(self); },
                                    &events};
  for (int replay = 0; replay < replays; ++replay) { // in turn, so that other load of the machine affects all of them
    play({}, alone);
    events = 0;
    play(counting, counted);
    director::Recorder recorder{soccer::names::all(), "/dev/null"}; // its thread writes JSON lines, without a slow disk
    play(recorder.observer(), recorded, std::chrono::milliseconds(200));
    dropped = recorder.dropped();
  }
  const auto each = [&](const std::vector<double>& times) {
    return (total(times) - total(alone)) / static_cast<double>(events);
  };
  return {{"an observer that counts", events, each(counted), 0},
          {"`director::Recorder`", events, each(recorded), dropped}};
}

} // namespace bench
