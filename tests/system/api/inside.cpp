// Header: tests/system/api/CMakeLists.txt. Test: itself.
// SPDX-License-Identifier: MIT
//
// A body that calls the behaviour itself: an assertion fails, which only a program of its own can survive.
#include "janitor.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string_view>
#include <tuple>

namespace {

std::string_view word;

struct House final : janitor::House {
  director::Outcome provide(janitor::Rest::Default& run) override {
    if (word == "request") behaviour->request<janitor::Sweep>();
    if (word == "cancel") behaviour->cancel<janitor::Rest>();
    if (word == "cancel_all") behaviour->cancel_all();
    if (word == "set") std::ignore = behaviour->set(janitor::Door::open);
    if (word == "enable") std::ignore = behaviour->enable<janitor::Sweep::Default>(false);
    if (word == "step") behaviour->step();
    if (word == "post") std::ignore = behaviour->post().set(janitor::Door::open);
    return run.keep();
  }
  director::Outcome provide(janitor::Sweep::Default& run) override { return run.keep(); }
  director::Outcome provide(janitor::Polish::Default& run) override { return run.keep(); }
  director::Outcome provide(janitor::Walk::Default& run) override { return run.keep(); }
  void stop(janitor::Walk::Stop&) override {}
  janitor::Behaviour* behaviour = nullptr;
};

} // namespace

int main(int count, char** arguments) {
  word = count > 1 ? arguments[1] : "";
  std::signal(SIGABRT, [](int) { std::_Exit(0); });
  House house;
  janitor::Behaviour behaviour{house};
  house.behaviour = &behaviour;
  behaviour.request<janitor::Rest>();
  behaviour.step();
  return 0;
}
