// SPDX-License-Identifier: MIT
// A rover whose bodies do what the scenario of the pages scripts: both print the same.
#include "rover.hpp"
#include "runtime/hosted/decision_printer.hpp"
#include "tests/docs/rover/scripted.hpp"
#include "tests/support/command.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <string>

using namespace std::chrono_literals;

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
