#pragma once
// SPDX-License-Identifier: MIT
// Shape: what the robot senses, as the behaviour's states. Only what has changed is told; the ball, with every picture.

#include "behaviours/soccer/world/world.hpp"
#include "soccer.hpp"

namespace player {

class Senses {
public:
  explicit Senses(const sim::World& world) : world_(world) {}

  void tell(soccer::Behaviour& behaviour);

private:
  const sim::World& world_;
  soccer::GamePhase phase_ = soccer::GamePhase::initial;
  sim::Posture posture_ = sim::Posture::upright;
};

} // namespace player
