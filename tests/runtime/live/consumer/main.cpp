// SPDX-License-Identifier: MIT
#include "lamp.hpp"
#include "lamp_page.hpp"
#include "runtime/live/live_view.hpp"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <thread>

namespace {

using namespace std::chrono_literals;

class SwitchBoard final : public lamp::Switch_board {
public:
  director::Outcome provide(lamp::Shine::Default& run) override {
    run.set(lamp::Light::bright);
    return run.keep();
  }
};

volatile std::sig_atomic_t stopping = 0;

} // namespace

int main() {
  SwitchBoard board;
  director::LiveView view{lamp::names::all(), {.html = director::pages::lamp()}};
  lamp::Behaviour behaviour{board, view.observer()};
  if (!view.good()) std::fprintf(stderr, "%s\n", view.error().c_str());
  view.allow_commands(behaviour.post());
  std::printf("%s\n", view.url().c_str());
  std::fflush(stdout);

  std::signal(SIGTERM, [](int) { stopping = 1; });
  const auto begin = std::chrono::steady_clock::now();
  while (stopping == 0) {
    behaviour.step(std::chrono::steady_clock::now() - begin);
    view.show(behaviour);
    std::this_thread::sleep_for(10ms);
  }
  view.forbid_commands();
  std::printf("the lamp is %s\n", behaviour.state<lamp::Shine>() == director::RunState::running ? "bright" : "dark");
}
