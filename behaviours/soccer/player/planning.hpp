#pragma once
// SPDX-License-Identifier: MIT
// Shape: places turned into steps, and a goal into a kick (planning.yaml).

#include "behaviours/soccer/world/robot.hpp"
#include "soccer.hpp"

namespace player {

class Planning final : public soccer::Planning {
public:
  explicit Planning(const sim::Robot& robot) : robot_(robot) {}

  director::Outcome provide(soccer::WalkTo::Default& run) override;
  director::Outcome provide(soccer::KickTo::Default& run) override;

private:
  const sim::Robot& robot_;
};

} // namespace player
