#pragma once
// SPDX-License-Identifier: MIT
// Which groups are stale, and which requests have to wait for them. docs/semantics.md, section 4.4, Stale and Defer.

#include "runtime/core/arbitration/context.hpp"

namespace director::arbitration {

inline constexpr Index up_to_date = static_cast<Index>(nil - 1); ///< instead of a group: not stale

DIRECTOR_PART Index stale_source(const Context& x, Index group);
DIRECTOR_PART bool wait_for_requester(Context& x, Index count);
DIRECTOR_PART void defer(Context& x, Index count);
DIRECTOR_PART bool takes_from_stale(Context& x, Index count);
bool reached_from_stale(Context& x, Index found, Index edge);
bool becomes_stale(const Context& x, Index group);

inline bool is_marked_stale(const Context& x, Index group) { return x.s.group_marks[group].has(mark::stale); }

/// Whether the group is stale; notes that it matters whether the group because of which it is so is stale.
inline bool note_if_stale(Context& x, Index group) {
  const Index source = stale_source(x, group);
  if (source < x.t.groups.size()) x.s.run_queue[source].stale_matters = 1;
  return source != up_to_date;
}

/// Whether, for a member that was not granted, the choices claim what an earlier stale group may still request.
inline bool premature(Context& x, Index count) { return x.stale_granted != 0 && takes_from_stale(x, count); }

inline bool stale_requester(const Context& x, Index edge) {
  const Index group = x.t.edges[edge].requester;
  return group != nil && stale_source(x, group) != up_to_date;
}

} // namespace director::arbitration
