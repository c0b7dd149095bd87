#pragma once
// SPDX-License-Identifier: MIT
// What an observer was told, to be compared whole.

#include "runtime/core/base/observer.hpp"

#include <array>
#include <cstdint>

namespace director::tests {

/// Each member as a number.
using EventNumbers = std::array<std::int64_t, 20>;

/// `shift`: so much later than in what it is compared with are the times of this engine.
inline EventNumbers numbers_of(const Event& e, Time shift = 0) {
  const auto number = [](auto member) { return static_cast<std::int64_t>(member); };
  const auto time = [&](Time t) { return t == never ? never : t - shift; };
  return {number(e.kind),      number(e.input),     number(e.reasons.bits()),
          number(e.why),       number(e.group),     number(e.provider),
          number(e.edge),      number(e.other),     number(e.state),
          number(e.condition), number(e.trigger),   number(e.level),
          number(e.outcome),   number(e.pack),      number(e.value),
          number(e.count),     time(e.time),        time(e.until),
          time(e.due),         number(e.micro_step)};
}

} // namespace director::tests
