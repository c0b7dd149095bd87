#pragma once
// SPDX-License-Identifier: MIT
// Shape: legs whose controller moves all their servos at once (legs.yaml).

#include "behaviours/soccer/world/robot.hpp"
#include "soccer.hpp"

namespace player {

class Legs final : public soccer::Legs {
public:
  explicit Legs(sim::Robot& robot) : robot_(robot) {}

  director::Outcome provide(soccer::LeftLeg::Default& run) override;
  director::Outcome provide(soccer::RightLeg::Default& run) override;

private:
  sim::Robot& robot_;
};

} // namespace player
