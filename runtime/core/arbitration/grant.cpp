// docs/semantics.md, section 4.4, Grant: a unit gets its targets, and all that their plans need.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/grant.hpp"

#include "runtime/core/arbitration/push.hpp"

namespace director::arbitration {

/// Decides a unit of one edge, or one member of a stale requester.
void decide_alone(Context& x, Index edge, bool below_stale) {
  x.s.member[0].edge = edge;
  try_members(x, 1, below_stale);
}

/// Grants the current members all together, or refuses them.
void try_members(Context& x, Index count, bool below_stale) {
  if (below_stale && wait_for_requester(x, count)) return;
  if (count == 1 && taken(x, x.s.member[0].edge)) return leave_queued(x, 1, Why::blocked);
  if (!combine(x, count, true)) return x.t.conditions.empty() ? leave_queued(x, count, Why::blocked) : refuse(x, count);
  if (!premature(x, count)) return grant(x, count);
  x.depends_on_stale = true;
  leave_combination(x, count);
  defer(x, count); // the requester is not stale, so the current members are the whole unit
}

void grant(Context& x, Index count) {
  for (Index at = 0; at < count; ++at) {
    const Index edge = x.s.member[at].edge, group = x.t.edges[edge].target;
    grant_target(x, edge, x.s.member[at].provider);
    const Index begin = entries_begin(x, at), end = x.s.member[at].entries_end;
    if (begin != end) claim_plan(x, group, x.s.member[at].provider, begin, end);
  }
  if (x.pushed_count != 0) keep_own_pushes(x, count);
  leave_combination(x, count);
}

/// Refuses the current members. Blocked: no combination is available, even without regard to conditions.
void leave_queued(Context& x, Index count, Why why, Index condition) {
  for (const TriedMember& member : members(x, count)) {
    x.s.edge_marks[member.edge] |= mark::refused;
    x.s.queued[member.edge] = {why, condition};
  }
}

} // namespace director::arbitration
