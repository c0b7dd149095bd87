#pragma once
// SPDX-License-Identifier: MIT
// Shape: legs that move one servo after another (servos.yaml).

#include "behaviours/soccer/world/robot.hpp"
#include "soccer.hpp"

namespace player {

class Servos final : public soccer::Servos {
public:
  explicit Servos(sim::Robot& robot) : robot_(robot) {}

  director::Outcome provide(soccer::LeftLeg::Default& run) override;
  director::Outcome provide(soccer::RightLeg::Default& run) override;
  director::Outcome provide(soccer::LeftHipYaw::Default& run) override;
  director::Outcome provide(soccer::LeftKnee::Default& run) override;
  director::Outcome provide(soccer::LeftAnkle::Default& run) override;
  director::Outcome provide(soccer::RightHipYaw::Default& run) override;
  director::Outcome provide(soccer::RightKnee::Default& run) override;
  director::Outcome provide(soccer::RightAnkle::Default& run) override;

private:
  sim::Robot& robot_;
};

} // namespace player
