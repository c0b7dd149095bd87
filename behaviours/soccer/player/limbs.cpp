// Header: behaviours/soccer/player/limbs.hpp. Test: tests/behaviours/soccer.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/player/limbs.hpp"

#include "behaviours/soccer/player/turn_servo.hpp"

namespace player {

using director::Outcome;
using sim::Servo;

Outcome Limbs::provide(soccer::LeftArm::Default& run) {
  return turn_servo(run, robot_, Servo::left_arm, run.task().shoulder);
}

Outcome Limbs::provide(soccer::RightArm::Default& run) {
  return turn_servo(run, robot_, Servo::right_arm, run.task().shoulder);
}

Outcome Limbs::provide(soccer::Head::Default& run) {
  robot_.move(Servo::neck, run.task().yaw); // nobody waits for the eyes
  return run.keep();
}

} // namespace player
