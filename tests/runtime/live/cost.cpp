// Header: tests/runtime/live/CMakeLists.txt. Test: none, it prints what docs/performance.md says.
// SPDX-License-Identifier: MIT
//
// live_cost [GAMES]: prints the cost of a live view for the thread that steps, in processor time for each event: ten
// minutes of soccer, some thirty times as fast as real time, with several numbers of viewers. Of several games the
// fastest counts.
#include "behaviours/soccer/player/player.hpp"
#include "behaviours/soccer/player/servos.hpp"
#include "behaviours/soccer/world/world.hpp"
#include "runtime/live/live_view.hpp"
#include "tests/runtime/live/client.hpp"

#include <poll.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <thread>
#include <vector>

namespace {

using namespace director;
using namespace director::tests;
using namespace std::chrono_literals;

double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

struct Game {
  double nanoseconds = 0;
  std::uint64_t events = 0, dropped = 0;
};

Game play(Observer observer, LiveView* view, const std::uint64_t& events) {
  sim::World world{1};
  player::Player<player::Servos> player{world, observer};
  Game out;
  for (int step = 0; step < 60'000; ++step) {
    world.step();
    const double begin = processor_time();
    player.step();
    if (view != nullptr) view->show(player.behaviour());
    out.nanoseconds += processor_time() - begin;
    if (step % 10 == 0) std::this_thread::sleep_for(1ms);
  }
  out.events = events;
  return out;
}

/// Half of the viewers read, if there are several.
Game play_with(std::size_t viewers) {
  LiveView view{soccer::names::all(), {.connections = 256}};
  std::vector<Caller> callers;
  for (std::size_t i = 0; i < viewers; ++i) callers.emplace_back(view.url()).send(get(view.url(), "events"));
  while (view.viewers() != viewers) std::this_thread::sleep_for(1ms);
  std::atomic<bool> over{false};
  std::thread reading([&] {
    std::string received;
    for (; !over; received.clear()) {
      for (std::size_t i = 0; i < (viewers + 1) / 2; ++i) callers[i].read(received);
      std::this_thread::sleep_for(5ms);
    }
  });
  struct Counting {
    LiveView* view;
    std::uint64_t events = 0;
  } counting{&view};
  const Observer observer{[](void* self, const Event& event) {
                            auto& to = *static_cast<Counting*>(self);
                            ++to.events;
                            to.view->tell(event);
                          },
                          &counting};
  Game out = play(observer, &view, counting.events);
  out.dropped = view.dropped();
  over = true;
  reading.join();
  return out;
}

} // namespace

int main(int count, char** values) {
  const int games = count > 1 ? std::atoi(values[1]) : 5;
  const auto least = [&](auto once) {
    Game out = once();
    for (int i = 1; i < games; ++i) {
      const Game again = once();
      if (again.nanoseconds < out.nanoseconds) out = again;
    }
    return out;
  };
  const std::uint64_t none = 0;
  const Game alone = least([&] { return play({}, nullptr, none); });
  std::uint64_t told = 0;
  const Game counted = least([&] {
    told = 0;
    return play({[](void* self, const Event&) { ++*static_cast<std::uint64_t*>(self); }, &told}, nullptr, told);
  });
  const auto events = static_cast<double>(counted.events);
  std::printf("ten minutes of soccer: 60000 steps, %.0f events, %.0f ns a step that nobody observes\n", events,
              alone.nanoseconds / 60'000);
  std::printf("an observer that counts:   %5.1f ns an event\n", (counted.nanoseconds - alone.nanoseconds) / events);
  for (const std::size_t viewers : {std::size_t{0}, std::size_t{1}, std::size_t{200}}) {
    const Game game = least([&] { return play_with(viewers); });
    std::printf("a view with %3zu viewers:    %5.1f ns an event; %llu dropped\n", viewers,
                (game.nanoseconds - alone.nanoseconds) / events, static_cast<unsigned long long>(game.dropped));
  }
}
