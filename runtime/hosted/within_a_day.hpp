#pragma once
// SPDX-License-Identifier: MIT
// How long a thread of the runtime's own may be told to wait: with a pause, and not beyond what a clock can add. A
// longer time, up to the longest duration, is a day; none, or less, a millisecond.

#include <algorithm>
#include <chrono>

namespace director {

constexpr std::chrono::milliseconds within_a_day(std::chrono::milliseconds time) {
  return std::clamp<std::chrono::milliseconds>(time, std::chrono::milliseconds(1), std::chrono::hours(24));
}

} // namespace director
