#pragma once
// SPDX-License-Identifier: MIT
// Bodies of the rover that do what the scenario of the pages scripts.

#include "rover.hpp"

#include <chrono>

class ScriptedMission final : public rover::Mission {
public:
  director::Outcome provide(rover::Explore::Default& run) override { return run.request(rover::Drive{{}}); }
  director::Outcome provide(rover::Photograph::Default& run) override {
    if (run.uses<rover::Camera>().done()) return run.done();
    return run.request(rover::Wheels{{}}, rover::Camera{});
  }
};

class ScriptedChassis final : public rover::Chassis {
public:
  void stop(rover::Drive::Stop&) override {}
  director::Outcome provide(rover::Drive::Rolling& run) override {
    run.set(rover::Motion::rolling);
    return run.request(rover::Wheels{{}});
  }
  director::Outcome provide(rover::Drive::Braking& run) override {
    if (run.reasons().has(director::Reason::pushed)) {
      run.wait(std::chrono::seconds(1));
      return run.request(rover::Wheels{{}});
    }
    run.set(rover::Motion::still);
    return run.keep();
  }
  director::Outcome provide(rover::Wheels::Default& run) override { return run.keep(); }
  director::Outcome provide(rover::Camera::Default& run) override { return run.done(); }
};
