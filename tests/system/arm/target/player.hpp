#pragma once
// SPDX-License-Identifier: MIT
// Plays a plan and prints the events in the form of `directorc simulate --decisions`.

#include "tests/system/arm/target/plan.hpp"

#include <cstddef>
#include <span>

namespace target {

struct Used {
  std::size_t state = 0;  ///< bytes of the engine's memory
  std::size_t memory = 0; ///< with the inbox and what the script needs; above the available memory: it was not played
  bool saved = false;     ///< there was enough memory to save the engine between steps, and to continue from that
};

/// `memory` is aligned to 8.
Used play(const Plan& plan, std::span<std::byte> memory);

} // namespace target
