#pragma once
// SPDX-License-Identifier: MIT
// Shape: arms and head (limbs.yaml). A limb is done when its servo is there.

#include "behaviours/soccer/world/robot.hpp"
#include "soccer.hpp"

namespace player {

class Limbs final : public soccer::Limbs {
public:
  explicit Limbs(sim::Robot& robot) : robot_(robot) {}

  director::Outcome provide(soccer::LeftArm::Default& run) override;
  director::Outcome provide(soccer::RightArm::Default& run) override;
  director::Outcome provide(soccer::Head::Default& run) override;

private:
  sim::Robot& robot_;
};

} // namespace player
