// SPDX-License-Identifier: MIT
// A rover that is recorded: the trace equals its scenario, and can be replayed.
#include "rover.hpp"
#include "runtime/hosted/trace/recorder.hpp"
#include "tests/docs/rover/scripted.hpp"
#include "tests/support/command.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <string>

using namespace std::chrono_literals;

TEST_CASE("what a rover records is what simulate prints, and can be played again") {
  const director::tests::TemporaryFolder folder;
  const std::string file = (folder.path() / "run.jsonl").string();
  {
    ScriptedMission mission;
    ScriptedChassis chassis;
    director::Recorder recorder{rover::names::all(), file};
    rover::Behaviour behaviour{mission, chassis, recorder.observer()};
    behaviour.request<rover::Explore>();
    behaviour.step(0s);
    behaviour.request<rover::Photograph>();
    behaviour.step(0s);
    behaviour.step(1s);
  }
  const auto source = director::tests::source_dir();
  const auto simulated = director::tests::run_command(
      "directorc simulate --decisions --times tests/docs/rover/rover.scenario.yaml | grep -v '> advance'", source);
  CHECK(director::tests::run_command("directorc trace " + file, source).output == simulated.output);
  const auto replayed =
      director::tests::run_command("directorc replay " + file + " --behaviour tests/docs/rover/rover.yaml", source);
  CHECK(replayed.output.find("events, all the same\n") != std::string::npos);
  CHECK(replayed.output.find("another version") == std::string::npos);
}
