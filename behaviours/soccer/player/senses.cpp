// Header: behaviours/soccer/player/senses.hpp. Test: tests/behaviours/soccer.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/player/senses.hpp"

#include <tuple>

namespace player {

using sim::Posture;
using soccer::Ball;
using soccer::Stability;

/// Between two steps: the inbox has room for all of it.
void Senses::tell(soccer::Behaviour& behaviour) {
  if (world_.phase() != phase_) std::ignore = behaviour.set(phase_ = world_.phase());

  const sim::Robot& robot = world_.robot();
  if (robot.posture() != posture_) {
    posture_ = robot.posture();
    if (posture_ == Posture::falling) std::ignore = behaviour.set(Stability::falling);
    if (posture_ == Posture::lying) std::ignore = behaviour.set(Stability::fallen);
  }

  if (!world_.new_picture()) return;
  const int away = length(robot.picture().ball - robot.pose().place);
  if (robot.picture().seen) std::ignore = behaviour.set(away < 400 ? Ball::near : away < 700 ? Ball::close : Ball::far);
  std::ignore = behaviour.fire<soccer::Vision>();
}

} // namespace player
