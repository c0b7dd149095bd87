#pragma once
// SPDX-License-Identifier: MIT
// Shape: where the eyes go (looking.yaml).

#include "soccer.hpp"

namespace player {

class Looking final : public soccer::Looking {
public:
  director::Outcome provide(soccer::LookAt::Default& run) override { return run.request(soccer::Head{run.task()}); }
};

} // namespace player
