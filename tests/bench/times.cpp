// Header: tests/bench/times.hpp. Test: tests/bench/CMakeLists.txt.
// SPDX-License-Identifier: MIT
#include "tests/bench/times.hpp"

#include "tests/system/no_heap/heap_trap.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <numeric>

namespace bench {

namespace {

constexpr int replays = 5;
constexpr double endless = std::numeric_limits<double>::max();

using Clock = std::chrono::steady_clock;

double nanoseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::nano>(Clock::now() - begin).count();
}

/// The time of reading the clock.
double cost_of_clock() {
  double least = endless;
  for (int i = 0; i < 10'000; ++i) least = std::min(least, nanoseconds_since(Clock::now()));
  return least;
}

/// The time of each input.
std::vector<double> least_times(const Workload& workload, std::uint64_t seed, double clock) {
  std::vector<double> out(workload.inputs, endless);
  for (int replay = 0; replay < replays; ++replay) {
    const std::unique_ptr<Playing> playing = workload.make(workload.size, seed, {});
    for (double& least : out) {
      playing->prepare();
      const director::tests::HeapTrap trap;
      const Clock::time_point begin = Clock::now();
      playing->take();
      least = std::min(least, std::max(0.0, nanoseconds_since(begin) - clock));
    }
  }
  return out;
}

double time_by_hand(Tape& tape) {
  double least = endless;
  for (int replay = 0; replay < replays; ++replay) {
    const Clock::time_point begin = Clock::now();
    tape.play();
    least = std::min(least, nanoseconds_since(begin));
  }
  return least;
}

} // namespace

Times take_times(const Workload& workload) {
  Times out;
  std::vector<double> all;
  const double clock = cost_of_clock();
  const std::size_t uses = director::tests::heap_uses();
  for (std::uint64_t seed = 1; seed <= workload.seeds; ++seed) {
    const std::vector<double> some = least_times(workload, seed, clock);
    all.insert(all.end(), some.begin(), some.end());
    Tape tape = record(workload, seed, workload.inputs);
    out.by_hand += time_by_hand(tape);
    out.calls += static_cast<double>(tape.calls());
  }
  const auto inputs = static_cast<double>(all.size());
  out.heap_uses = director::tests::heap_uses() - uses;
  out.by_hand /= inputs;
  out.calls /= inputs;
  out.mean = std::accumulate(all.begin(), all.end(), 0.0) / inputs;
  std::sort(all.begin(), all.end());
  const auto at = [&](double share) { return all[static_cast<std::size_t>(share * (inputs - 1))]; };
  out.p50 = at(0.5);
  out.p99 = at(0.99);
  out.p999 = at(0.999);
  out.max = all.back();
  return out;
}

} // namespace bench
