#pragma once
// SPDX-License-Identifier: MIT
// Whether a unit is granted, blocked or refused. docs/semantics.md, section 4.4, Grant and Refuse.

#include "runtime/core/arbitration/trail.hpp"

namespace director::arbitration {

void decide_alone(Context& x, Index edge, bool below_stale);
void try_members(Context& x, Index count, bool below_stale);
void grant(Context& x, Index count);
DIRECTOR_PART void refuse(Context& x, Index count); // refuse.cpp
void leave_queued(Context& x, Index count, Why why, Index condition = nil);

/// Claims a group that is free, or that this edge has claimed already.
DIRECTOR_ONE_COPY inline void claim(Context& x, Index group, Index edge) {
  open(x, group);
  x.s.now[group].holder = edge;
}

/// Claims the target of an edge, and marks it as granted with this provider.
DIRECTOR_ONE_COPY inline void grant_target(Context& x, Index edge, Index provider) {
  const Index group = x.t.edges[edge].target;
  claim(x, group, edge);
  GroupAssignment& now = x.s.now[group];
  const GroupAssignment& last = x.s.last[group];
  now.active = now.planned = provider;
  now.flags |= flag::granted;
  x.s.queued[edge] = Queued{};
  if (x.t.groups[group].edges.empty()) return; // no decision depends on whether it is stale
  if (!x.s.run_queue[group].pending.has(reason::makes_stale) && x.s.anew[edge] == 0 && edge == last.holder &&
      provider == last.active)
    return;
  x.s.group_marks[group] |= mark::stale;
  ++x.stale_granted;
}

} // namespace director::arbitration
