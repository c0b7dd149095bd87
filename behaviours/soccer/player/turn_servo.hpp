#pragma once
// SPDX-License-Identifier: MIT
// Shape: one servo's task, the same for each of them: go there, and say Done when it is there.

#include "behaviours/soccer/world/robot.hpp"
#include "soccer.hpp"

#include <chrono>

namespace player {

template <class Run>
director::Outcome turn_servo(Run& run, sim::Robot& robot, sim::Servo servo, sim::Angle to) {
  if (!run.reasons().has(director::Reason::new_task)) return run.done();
  run.wait(std::chrono::milliseconds(robot.move(servo, to)));
  return run.keep();
}

} // namespace player
