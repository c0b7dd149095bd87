// Header: none, a program. Test: tests/behaviours/greenhouse/programs_test.cpp.
// SPDX-License-Identifier: MIT
//
// An interrupt posts. On a computer a signal comes nearest to one: it stops the program wherever it is, here in the
// middle of a body, and its handler may do next to nothing. To post is allowed: nothing locks and nothing allocates.
#include "behaviours/greenhouse/house.hpp"

#include <chrono>
#include <csignal>
#include <optional>

namespace {

std::optional<greenhouse::Behaviour::Post> way_in;

void on_signal(int) { way_in->request<greenhouse::Storm>(); } // a root task: never refused, however full the inbox is

class WindyGardener final : public Gardener {
public:
  using Gardener::provide;
  director::Outcome provide(greenhouse::Storm::Default& run) override {
    std::puts("storm");
    return Gardener::provide(run);
  }
  director::Outcome provide(greenhouse::Airing::Opening& run) override {
    std::raise(SIGINT); // the wind gauge, or somebody at the keyboard
    std::puts("the body that was interrupted goes on");
    return Gardener::provide(run);
  }
};

} // namespace

int main() {
  WindyGardener gardener;
  House house;
  greenhouse::Behaviour behaviour{gardener, house};
  way_in = behaviour.post();
  std::signal(SIGINT, on_signal);

  behaviour.request<greenhouse::Garden>();
  if (!behaviour.set(greenhouse::Air::hot)) return 1;
  for (std::chrono::milliseconds now{0}; now < std::chrono::milliseconds{30}; now += std::chrono::milliseconds{10})
    behaviour.step(now);
}
