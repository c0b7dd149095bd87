// Header: behaviours/soccer/player/legs.hpp. Test: tests/behaviours/soccer.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/player/legs.hpp"

#include <algorithm>
#include <chrono>

namespace player {

using director::Outcome;
using sim::Servo;

namespace {

template <class Run>
Outcome all_at_once(Run& run, sim::Robot& robot, Servo hip, Servo knee, Servo ankle) {
  if (!run.reasons().has(director::Reason::new_task)) return run.done();
  const soccer::LegMove& move = run.task();
  const sim::Milliseconds longest =
      std::max({robot.move(hip, move.hip), robot.move(knee, move.knee), robot.move(ankle, move.ankle)});
  run.wait(std::chrono::milliseconds(2 * longest)); // its controller settles before it answers
  return run.keep();
}

} // namespace

Outcome Legs::provide(soccer::LeftLeg::Default& run) {
  return all_at_once(run, robot_, Servo::left_hip_yaw, Servo::left_knee, Servo::left_ankle);
}

Outcome Legs::provide(soccer::RightLeg::Default& run) {
  return all_at_once(run, robot_, Servo::right_hip_yaw, Servo::right_knee, Servo::right_ankle);
}

} // namespace player
