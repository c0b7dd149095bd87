// Header: behaviours/soccer/player/servos.hpp. Test: tests/behaviours/soccer.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/player/servos.hpp"

#include "behaviours/soccer/player/turn_servo.hpp"

namespace player {

using director::Outcome;
using director::Reason;
using sim::Servo;

namespace {

/// Hip, knee, foot: the Done of one is the turn of the next.
template <class Hip, class Knee, class Ankle, class Run>
Outcome one_after_another(Run& run) {
  const soccer::LegMove& move = run.task();
  if (run.reasons().has(Reason::new_task)) return run.turn_hip(Hip{{move.hip}});
  if (run.template uses<Hip>().done()) return run.bend_knee(Knee{{move.knee}});
  if (run.template uses<Knee>().done()) return run.set_foot(Ankle{{move.ankle}});
  return run.done();
}

} // namespace

Outcome Servos::provide(soccer::LeftLeg::Default& run) {
  return one_after_another<soccer::LeftHipYaw, soccer::LeftKnee, soccer::LeftAnkle>(run);
}

Outcome Servos::provide(soccer::RightLeg::Default& run) {
  return one_after_another<soccer::RightHipYaw, soccer::RightKnee, soccer::RightAnkle>(run);
}

Outcome Servos::provide(soccer::LeftHipYaw::Default& run) {
  return turn_servo(run, robot_, Servo::left_hip_yaw, run.task().to);
}

Outcome Servos::provide(soccer::LeftKnee::Default& run) {
  return turn_servo(run, robot_, Servo::left_knee, run.task().to);
}

Outcome Servos::provide(soccer::LeftAnkle::Default& run) {
  return turn_servo(run, robot_, Servo::left_ankle, run.task().to);
}

Outcome Servos::provide(soccer::RightHipYaw::Default& run) {
  return turn_servo(run, robot_, Servo::right_hip_yaw, run.task().to);
}

Outcome Servos::provide(soccer::RightKnee::Default& run) {
  return turn_servo(run, robot_, Servo::right_knee, run.task().to);
}

Outcome Servos::provide(soccer::RightAnkle::Default& run) {
  return turn_servo(run, robot_, Servo::right_ankle, run.task().to);
}

} // namespace player
