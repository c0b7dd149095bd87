// SPDX-License-Identifier: MIT
// The rover of the pages is saved while it brakes, and continues in another object.
#include "rover.hpp"
#include "runtime/hosted/trace/recorder.hpp"
#include "tests/docs/rover/scripted.hpp"
#include "tests/support/command.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <string>

using namespace std::chrono_literals;

TEST_CASE("a rover that was saved while it brakes takes its picture in another object") {
  ScriptedMission mission;
  ScriptedChassis chassis;
  rover::Behaviour behaviour{mission, chassis};
  behaviour.request<rover::Explore>();
  behaviour.step(0s);
  behaviour.request<rover::Photograph>();
  behaviour.step(0s); // it brakes, and looks again in a second

  std::array<std::byte, rover::Behaviour::saved_bytes()> bytes;
  if (const auto result = behaviour.save(bytes); result != director::SaveResult::saved)
    throw std::runtime_error(director::to_text(result));

  rover::Behaviour other{mission, chassis};
  if (const auto result = other.load(bytes, 60s); result != director::LoadResult::loaded)
    throw std::runtime_error(director::to_text(result));
  CHECK(other.state<rover::Photograph>() == director::RunState::queued);
  other.step(61s); // a second later it stands
  CHECK(other.state<rover::Photograph>() == director::RunState::none); // it is done

  std::array<std::byte, 100> small;
  CHECK(behaviour.save(small) == director::SaveResult::too_small);
}

TEST_CASE("a recorder that goes on with the object that loads writes one trace, which can be played again") {
  const director::tests::TemporaryFolder folder;
  const std::string file = (folder.path() / "run.jsonl").string();
  {
    ScriptedMission mission;
    ScriptedChassis chassis;
    director::Recorder recorder{rover::names::all(), file};
    rover::Behaviour behaviour{mission, chassis, recorder.observer()}, other{mission, chassis, recorder.observer()};
    behaviour.request<rover::Explore>();
    behaviour.step(0s);
    behaviour.request<rover::Photograph>();
    behaviour.step(0s);
    std::array<std::byte, rover::Behaviour::saved_bytes()> bytes;
    REQUIRE(behaviour.save(bytes) == director::SaveResult::saved);
    REQUIRE(other.load(bytes, 0s) == director::LoadResult::loaded);
    other.step(1s);
  }
  const auto source = director::tests::source_dir();
  const auto simulated = director::tests::run_command(
      "directorc simulate --decisions --times tests/docs/rover/rover.scenario.yaml | grep -v '> advance'", source);
  CHECK(director::tests::run_command("directorc trace " + file, source).output == simulated.output);
  const auto replayed =
      director::tests::run_command("directorc replay " + file + " --behaviour tests/docs/rover/rover.yaml", source);
  CHECK(replayed.output.find("events, all the same\n") != std::string::npos);
}
