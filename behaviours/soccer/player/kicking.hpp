#pragma once
// SPDX-License-Identifier: MIT
// Shape: the kick (kicking.yaml): back, through the ball, and down again.

#include "soccer.hpp"

namespace player {

class Kicking final : public soccer::Kicking {
public:
  director::Outcome provide(soccer::Kick::Default& run) override;

private:
  enum class Stage { back, through, down };
  Stage stage_ = Stage::back;
};

} // namespace player
