#pragma once
// SPDX-License-Identifier: MIT
// Bits that passes set on edges, groups, conditions and providers.

#include "runtime/core/base/state.hpp"

namespace director {

namespace mark {
// On edges.
inline constexpr std::uint8_t tried = 1; ///< it was tried, or must not be
inline constexpr std::uint8_t refused = 2;
inline constexpr std::uint8_t alone = 4;       ///< it is a unit by itself
inline constexpr std::uint8_t below_stale = 8; ///< its requester is stale
inline constexpr std::uint8_t pushes = 16;     ///< it made a push in the last assignment
inline constexpr std::uint8_t visited = 32;    ///< it was decided, or keeps its last decision
inline constexpr std::uint8_t optional = 64;   ///< it is optional, and was not postponed yet
// On groups.
inline constexpr std::uint8_t forgotten = 1; ///< its last holder, an equal, no longer counts
inline constexpr std::uint8_t denied = 2;    ///< it was denied to an equal of its last holder
inline constexpr std::uint8_t reached = 4;
inline constexpr std::uint8_t busy = 8;     ///< its push serves a condition of the current unit
inline constexpr std::uint8_t stale = 16;   ///< it is granted, has edges, and its pack may be out of date
inline constexpr std::uint8_t differs = 32; ///< its assignment differs from that of the last pass
inline constexpr std::uint8_t listed = 64;  ///< it is listed in State::pushed
// On conditions.
inline constexpr std::uint8_t lacked = 1; ///< the searched chain may have to make it true
// On providers.
inline constexpr std::uint8_t causer = 1; ///< it is listed in State::causers
} // namespace mark

/// What remains of the last pass for the next one.
namespace trail {
// Bits of State::edge_trail.
inline constexpr std::uint8_t reached = 1;       ///< something on which its decision depends may have changed
inline constexpr std::uint8_t changed = 2;       ///< since the last pass it is requested at another level, or no longer
inline constexpr std::uint8_t on_last = 4;       ///< its decision may differ if the last result is its own
inline constexpr std::uint8_t on_stale = 8;      ///< or if other groups are stale: it is decided in every pass
inline constexpr std::uint8_t waits = 16;        ///< it waits for a group that is pushed, or searched for one
inline constexpr std::uint8_t in_line = 32;      ///< it is blocked only because an earlier edge has claimed its target
inline constexpr std::uint8_t on_requester = 64; ///< its decision may differ once its requester is not stale
inline constexpr std::uint8_t altered = 128;     ///< its request before this micro-step is in State::before
inline constexpr std::uint8_t kept = on_last | on_stale | waits | in_line | on_requester;
// Bits of State::group_trail.
inline constexpr std::uint8_t disturbed = 1; ///< its holder, provider, plan or push may have changed
inline constexpr std::uint8_t moved = 2;     ///< its place in the order may have changed
inline constexpr std::uint8_t flipped = 4;   ///< since the last pass a condition of a provider flipped
inline constexpr std::uint8_t stale = 8;     ///< it was stale in the last pass
inline constexpr std::uint8_t requests = 16; ///< its requests were candidates in the last pass
inline constexpr std::uint8_t opened = 32;   ///< this pass examines it
inline constexpr std::uint8_t passed = 64;   ///< it was passed by, with all below it
inline constexpr std::uint8_t again = 128;   ///< the next pass has to open it in any case
} // namespace trail

} // namespace director
