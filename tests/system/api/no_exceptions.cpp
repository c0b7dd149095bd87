// Header: runtime/hosted/trial.hpp. Test: itself.
// SPDX-License-Identifier: MIT
//
// Modules that are compiled without exceptions, tested alone: a mistake of the test is printed, and ends the program.
#include "janitor.hpp"
#include "runtime/hosted/trial.hpp"

#include <csignal>
#include <cstdlib>
#include <string_view>

namespace {

struct House final : janitor::House {
  director::Outcome provide(janitor::Rest::Default& run) override {
    return walks ? run.request(janitor::Walk{5}) : run.request();
  }
  director::Outcome provide(janitor::Sweep::Default& run) override { return run.keep(); }
  director::Outcome provide(janitor::Polish::Default& run) override { return run.keep(); }
  director::Outcome provide(janitor::Walk::Default& run) override { return run.keep(); }
  void stop(janitor::Walk::Stop&) override {}
  bool walks = true;
};

} // namespace

int main(int count, char** arguments) {
  std::signal(SIGABRT, [](int) { std::_Exit(0); });
  House house;
  house.walks = count < 2 || std::string_view(arguments[1]) != "mistake";
  director::testing::Trial<janitor::Rest::Default> rest;
  return rest.run(house).data<janitor::Walk>() == 5 ? 0 : 1;
}
