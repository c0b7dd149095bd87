#pragma once
// SPDX-License-Identifier: MIT
// Shape: falling well and getting up again (recovery.yaml).

#include "soccer.hpp"

namespace player {

class Recovery final : public soccer::Recovery {
public:
  director::Outcome provide(soccer::Brace::Default& run) override;
  director::Outcome provide(soccer::GetUp::Tucking& run) override;
  director::Outcome provide(soccer::GetUp::Pushing& run) override;
  director::Outcome provide(soccer::GetUp::Rising& run) override;
};

} // namespace player
