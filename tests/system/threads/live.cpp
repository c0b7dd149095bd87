// SPDX-License-Identifier: MIT
// A behaviour that is stepped, shown, and controlled by commands, while viewers come, read, read nothing and go, under
// the thread sanitizer.
#include "courier.hpp"
#include "runtime/live/live_view.hpp"
#include "tests/runtime/live/client.hpp"
#include "tests/system/api/office.hpp"

#include <cstdio>
#include <cstdlib>
#include <thread>

namespace {

using namespace director;
using namespace director::tests;
using namespace std::chrono_literals;

/// Looks, asks why, commands, leaves.
void look(const std::string& url) {
  for (int round = 0; round < 30; ++round) {
    const Caller deaf(url);
    deaf.send(get(url, "events"));
    const Caller viewer(url);
    viewer.send(get(url, "events"));
    std::string received;
    while (received.size() < 4000 && viewer.read(received)) std::this_thread::sleep_for(1ms);
    const int why = call(url, get(url, "why?group=Walk")).status;
    const int done = call(url, get(url, round % 2 == 0 ? "request?task=Rest" : "cancel_all", "", "POST")).status;
    if ((why != 200 && why != 503) || done != 202) {
      std::fprintf(stderr, "live: why %d, command %d\n", why, done);
      std::exit(EXIT_FAILURE);
    }
  }
}

} // namespace

int main() {
  LiveView view{courier::names::all(), {.queue = 4096, .memory = 100'000, .interval = 1ms}};
  if (!view.good()) {
    std::fprintf(stderr, "live: %s\n", view.error().c_str());
    return EXIT_FAILURE;
  }
  Plans plans;
  plans.rest = [](courier::Rest::Default& run) { return run.request(courier::Walk{{}}, courier::Sing{}); };
  Skills skills;
  courier::Behaviour behaviour{plans, skills, view.observer()};
  view.allow_commands(behaviour.post());
  std::atomic<int> looking{3};
  std::thread viewers[3];
  for (std::thread& each : viewers)
    each = std::thread([&] {
      look(view.url());
      --looking;
    });
  for (auto now = 0us; looking != 0; now += 100us) {
    (void)behaviour.fire<courier::Bell>();
    behaviour.step(now);
    view.show(behaviour);
    std::this_thread::sleep_for(20us);
  }
  for (std::thread& each : viewers) each.join();
  view.forbid_commands();
  std::printf("%llu micro-steps\n", static_cast<unsigned long long>(behaviour.engine().micro_steps()));
}
