#pragma once
// SPDX-License-Identifier: MIT
// Bits that passes note on edges, groups, conditions and providers.

#include "runtime/core/base/state.hpp"
#include "runtime/core/base/tables.hpp"

namespace director {

namespace mark {
// On edges.
inline constexpr std::uint8_t tried = 1; ///< or may not be tried
inline constexpr std::uint8_t refused = 2;
inline constexpr std::uint8_t alone = 4;       ///< it is tried for itself
inline constexpr std::uint8_t below_stale = 8; ///< its requester's orders are outdated
inline constexpr std::uint8_t pushes = 16;     ///< there is a push of it in the last assignment
inline constexpr std::uint8_t visited = 32;    ///< it was decided, or stands as before
// On groups.
inline constexpr std::uint8_t forgotten = 1; ///< its last holder no longer stands in an equal's way
inline constexpr std::uint8_t denied = 2;    ///< it was denied to an equal of its last holder
inline constexpr std::uint8_t reached = 4;
inline constexpr std::uint8_t busy = 8;      ///< its push serves a condition of the unit in hand
inline constexpr std::uint8_t outdated = 16; ///< it is granted, may ask for others, and its orders are outdated
inline constexpr std::uint8_t differs = 32;  ///< it stands elsewhere than after the last pass
inline constexpr std::uint8_t listed = 64;   ///< it stands in State::pushed
// On conditions.
inline constexpr std::uint8_t lacked = 1; ///< the chain in search may have to make it true
// On providers.
inline constexpr std::uint8_t pushable = 1;
inline constexpr std::uint8_t looked_at = 2; ///< it is among those that cause what the chain in search lacks
} // namespace mark

/// What is known of the last pass, from pass to pass.
namespace trail {
// Bits of State::edge_trail.
inline constexpr std::uint8_t reached = 1;  ///< something that its decision looks at may be another than last time
inline constexpr std::uint8_t changed = 2;  ///< since the last pass it is requested at another level, or not any more
inline constexpr std::uint8_t on_last = 4;  ///< its decision may be another one when the last result is its own
inline constexpr std::uint8_t on_stale = 8; ///< or when the orders of others are outdated: it is decided in every pass
inline constexpr std::uint8_t waits = 16;   ///< it waits for somebody who is pushed, or searched for one
inline constexpr std::uint8_t behind = 32; ///< all that its decision looked at is that an edge before it has its target
inline constexpr std::uint8_t on_orders = 64; ///< or when its requester's orders are not outdated any more
inline constexpr std::uint8_t altered = 128;  ///< its request before this micro-step stands in State::before
inline constexpr std::uint8_t kept = on_last | on_stale | waits | behind | on_orders;
// Bits of State::group_trail.
inline constexpr std::uint8_t disturbed = 1; ///< its holder, provider, plan or push may be another than last time
inline constexpr std::uint8_t moved = 2;     ///< its place in the order may be another than last time
inline constexpr std::uint8_t touched = 4;   ///< since the last pass a condition of a provider flipped
inline constexpr std::uint8_t stale = 8;     ///< its orders were outdated in the last pass
inline constexpr std::uint8_t asks = 16;     ///< what it requests was looked at in the last pass
inline constexpr std::uint8_t opened = 32;   ///< this pass looks at it; otherwise it stands as it stood
inline constexpr std::uint8_t passed =
    64; ///< it, and all below it, stands as it stood and goes before the edge in hand
inline constexpr std::uint8_t again = 128; ///< the next pass has to look at it, whatever happens
} // namespace trail

/// Bits of RunQueueEntry::flags. What else there is to tell of the group stands there too.
namespace group_flag {
inline constexpr std::uint8_t queue = 1;     ///< it is to run
inline constexpr std::uint8_t touched = 2;   ///< it stands in State::touched
inline constexpr std::uint8_t waits = 4;     ///< its wait may be on
inline constexpr std::uint8_t listens = 8;   ///< to some trigger
inline constexpr std::uint8_t followed = 32; ///< its component is not decided whole (arbitration/trail.hpp)
inline constexpr std::uint8_t ends = 16;     ///< it has what begins or ends with it: states, a handler, a period
} // namespace group_flag

} // namespace director
