#pragma once
// SPDX-License-Identifier: MIT
// Shape: the bodies of a robot of the team. Its legs are a number; the world is the line between it and the ball.

#include "team.hpp"

namespace players {

class Player final : public team::Player {
public:
  director::Outcome provide(team::Halt::Default& run) override;
  director::Outcome provide(team::Play::Striking_as_one& run) override;
  director::Outcome provide(team::Play::Striking_as_two& run) override;
  director::Outcome provide(team::Play::Striking_as_three& run) override;
  director::Outcome provide(team::Play::Supporting& run) override;
  director::Outcome provide(team::Play::Searching& run) override;
  director::Outcome provide(team::Legs::Default& run) override;

  int cm_per_s() const { return cm_per_s_; } ///< towards the ball

private:
  int cm_per_s_ = 0;
};

} // namespace players
