#pragma once
// SPDX-License-Identifier: MIT
// Limits the time that a thread of the runtime waits, to at least a millisecond, so that it pauses, and at most a day,
// so that a clock can add it.

#include <algorithm>
#include <chrono>

namespace director {

constexpr std::chrono::milliseconds within_a_day(std::chrono::milliseconds time) {
  return std::clamp<std::chrono::milliseconds>(time, std::chrono::milliseconds(1), std::chrono::hours(24));
}

} // namespace director
