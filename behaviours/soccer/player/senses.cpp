// Door: behaviours/soccer/player/senses.hpp. Test: tests/behaviours/soccer.
#include "behaviours/soccer/player/senses.hpp"

namespace player {

using sim::Posture;
using soccer::Ball;
using soccer::Stability;

void Senses::tell(soccer::Behaviour& behaviour) {
  if (world_.phase() != phase_) behaviour.set(phase_ = world_.phase());

  const sim::Robot& robot = world_.robot();
  if (robot.posture() != posture_) {
    posture_ = robot.posture();
    if (posture_ == Posture::falling) behaviour.set(Stability::falling);
    if (posture_ == Posture::lying) behaviour.set(Stability::fallen);
  }

  if (!world_.new_picture()) return;
  const int away = length(robot.picture().ball - robot.pose().place);
  if (robot.picture().seen) behaviour.set(away < 400 ? Ball::near : away < 700 ? Ball::close : Ball::far);
  behaviour.fire<soccer::Vision>();
}

} // namespace player
