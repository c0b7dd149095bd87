// SPDX-License-Identifier: MIT
// A rover whose bodies do what the scenario of the pages scripts: what is printed of both is the same.
#include "rover.hpp"
#include "runtime/hosted/decision_printer.hpp"
#include "tests/support/command.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>

using namespace std::chrono_literals;

namespace {

using director::Outcome;
using director::Reason;

class ScriptedMission final : public rover::Mission {
public:
  Outcome provide(rover::Explore::Default& run) override { return run.request(rover::Drive{{}}); }
  Outcome provide(rover::Photograph::Default& run) override {
    if (run.uses<rover::Camera>().done()) return run.done();
    return run.request(rover::Wheels{{}}, rover::Camera{});
  }
};

class ScriptedChassis final : public rover::Chassis {
public:
  void stop(rover::Drive::Stop&) override {}
  Outcome provide(rover::Drive::Rolling& run) override {
    run.set(rover::Motion::rolling);
    return run.request(rover::Wheels{{}});
  }
  Outcome provide(rover::Drive::Braking& run) override {
    if (run.reasons().has(Reason::pushed)) {
      run.wait(1s);
      return run.request(rover::Wheels{{}});
    }
    run.set(rover::Motion::still);
    return run.keep();
  }
  Outcome provide(rover::Wheels::Default& run) override { return run.keep(); }
  Outcome provide(rover::Camera::Default& run) override { return run.done(); }
};

} // namespace

TEST_CASE("what a rover prints of its decisions is what simulate prints") {
  director::tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "decisions.txt";
  std::FILE* out = std::fopen(file.c_str(), "w");
  REQUIRE(out != nullptr);
  ScriptedMission mission;
  ScriptedChassis chassis;
  director::DecisionPrinter printer{rover::names::all(), out, director::DecisionPrinter::Times::yes};
  rover::Behaviour behaviour{mission, chassis, printer.observer()};
  behaviour.request<rover::Explore>();
  behaviour.step(0s);
  behaviour.request<rover::Photograph>();
  behaviour.step(0s);
  behaviour.step(1s);
  std::fclose(out);

  const auto simulated = director::tests::run_command(
      "directorc simulate --decisions --times tests/docs/rover/rover.scenario.yaml | grep -v '> advance'",
      director::tests::source_dir());
  CHECK(director::tests::read_file(file) == simulated.output);
}
