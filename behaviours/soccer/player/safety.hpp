#pragma once
// SPDX-License-Identifier: MIT
// Shape: what watches over falls (safety.yaml).

#include "soccer.hpp"

namespace player {

class Safety final : public soccer::Safety {
public:
  director::Outcome provide(soccer::FallRecovery::Recovering& run) override { return run.stand_up(soccer::GetUp{}); }
  director::Outcome provide(soccer::FallRecovery::Protecting& run) override { return run.protect(soccer::Brace{}); }
  director::Outcome provide(soccer::FallRecovery::Watching& run) override { return run.request(); }
};

} // namespace player
