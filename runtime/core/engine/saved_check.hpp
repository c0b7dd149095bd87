#pragma once
// SPDX-License-Identifier: MIT
// Whether bytes are a state that the engine can go on from.

#include "runtime/core/engine/saved_rows.hpp"

namespace director {

class Engine;

namespace saved {

/// Bits of ComponentRow::bits.
inline constexpr std::uint8_t component_bits =
    work::changed | work::unsettled | work::stale_counts | work::stale_changed;

/// The check sum is of what lies from this byte on: behind HeadRow::version and itself.
inline constexpr std::size_t summed_from = 8;

/// Of bytes that are as many as the tables ask for: every number is one of a row that there is and that may stand
/// there, and what the engine follows (holders, plans, the queue) comes to an end. Only scratch memory of the engine is
/// written.
bool is_possible(const Engine& engine, const std::byte* from);

} // namespace saved
} // namespace director
