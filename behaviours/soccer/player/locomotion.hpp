#pragma once
// SPDX-License-Identifier: MIT
// Shape: the walk (locomotion.yaml): step after step, or to a halt.

#include "behaviours/soccer/world/robot.hpp"
#include "soccer.hpp"

namespace player {

class Locomotion final : public soccer::Locomotion {
public:
  explicit Locomotion(sim::Robot& robot) : robot_(robot) {}

  void start(soccer::Walk::Start& run) override;
  void stop(soccer::Walk::Stop& run) override;
  director::Outcome provide(soccer::Walk::Walking& run) override;
  director::Outcome provide(soccer::Walk::Halting& run) override;

private:
  sim::Robot& robot_;
  int steps_ = 0;            ///< since the last order
  bool left_swings_ = false; ///< in this step
  bool together_ = false;    ///< the feet stand side by side
};

} // namespace player
