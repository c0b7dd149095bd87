#pragma once
// SPDX-License-Identifier: MIT
// Shape: what the striker wants (strategy.yaml): attack, go to its place, look for the ball.

#include "behaviours/soccer/world/robot.hpp"
#include "soccer.hpp"

namespace player {

class Strategy final : public soccer::Strategy {
public:
  explicit Strategy(const sim::Robot& robot) : robot_(robot) {}

  director::Outcome provide(soccer::Striker::Playing& run) override;
  director::Outcome provide(soccer::Striker::Ready& run) override;
  director::Outcome provide(soccer::Striker::Waiting& run) override;
  director::Outcome provide(soccer::KickToGoal::Default& run) override;
  director::Outcome provide(soccer::WalkToBall::Creeping& run) override;
  director::Outcome provide(soccer::WalkToBall::Striding& run) override;
  director::Outcome provide(soccer::WalkToBall::Searching& run) override;
  director::Outcome provide(soccer::WalkToReady::Default& run) override;
  director::Outcome provide(soccer::Look::Tracking& run) override;
  director::Outcome provide(soccer::Look::Sweeping& run) override;

private:
  bool asks_for_new_place(director::Reasons reasons) const;
  sim::Angle direction_of_ball() const;
  soccer::WalkTarget behind_ball(int distance, int longest_step) const;

  const sim::Robot& robot_;
  bool sweeps_left_ = false;
};

} // namespace player
