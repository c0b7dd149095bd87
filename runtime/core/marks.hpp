#pragma once
// Marks that one pass makes on edges, groups and conditions, and the one test that everybody needs.

#include "runtime/core/state.hpp"
#include "runtime/core/tables.hpp"

namespace director {

namespace mark {
// On edges.
inline constexpr std::uint8_t tried = 1;
inline constexpr std::uint8_t refused = 2;
// On groups.
inline constexpr std::uint8_t forgotten = 1; ///< its last holder no longer stands in an equal's way
inline constexpr std::uint8_t denied = 2;    ///< it was denied to an equal of its last holder
inline constexpr std::uint8_t reached = 4;
inline constexpr std::uint8_t busy = 8;       ///< its push serves a condition of the unit in hand
inline constexpr std::uint8_t outdated = 16;  ///< it is granted, and its orders are outdated
inline constexpr std::uint8_t differs = 32;   ///< it stands elsewhere than after the last pass
inline constexpr std::uint8_t looked_at = 64; ///< set only while a member's choices are searched for equals
// On conditions.
inline constexpr std::uint8_t wanted = 1;
} // namespace mark

/// Bits of State::in_queue.
namespace place {
inline constexpr std::uint8_t queue = 1;   ///< it is to run
inline constexpr std::uint8_t touched = 2; ///< it stands in State::touched
inline constexpr std::uint8_t counts = 4;  ///< that its orders were outdated made a difference in the last pass
inline constexpr std::uint8_t watched = 8; ///< in the last pass of its component it counted whose orders are outdated
} // namespace place

/// Bits of State::traits.
namespace trait {
inline constexpr std::uint8_t simple = 1;      ///< it has one provider, which needs nothing
inline constexpr std::uint8_t flat = 2;        ///< whatever its providers need is simple
inline constexpr std::uint8_t conditional = 4; ///< a provider has `when` or `stay`
} // namespace trait

/// Of a group.
inline std::uint8_t traits_of(const Tables& t, const Group& group) {
  const auto is_simple = [&](const Group& row) {
    return row.providers.size() == 1 && t.providers[row.providers.begin].needs.empty();
  };
  std::uint8_t out = is_simple(group) ? trait::flat | trait::simple : trait::flat;
  for (Index p = group.providers.begin; p != group.providers.end; ++p) {
    if (!t.providers[p].when.empty() || !t.providers[p].stay.empty()) out |= trait::conditional;
    for (const Index need : t.list(t.providers[p].needs)) {
      if (!is_simple(t.groups[t.edges[need].target])) out &= static_cast<std::uint8_t>(~trait::flat);
    }
  }
  return out;
}

/// A condition on an unset state is false.
inline bool accepts(const Tables& t, const Condition& condition, std::int32_t value) {
  if (value == unset) return false;
  for (Index i = condition.accepts.begin; i != condition.accepts.end; ++i) {
    if (t.intervals[i].low <= value && value <= t.intervals[i].high) return true;
  }
  return false;
}

} // namespace director
