// docs/semantics.md, section 4.4, Stale and Defer: which groups are stale, and which requests wait for them.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/staleness.hpp"

#include "runtime/core/arbitration/grant.hpp"
#include "runtime/core/arbitration/push.hpp"

const char director::part::staleness = 0;

namespace director::arbitration {

/// The granted group because of which a group is stale; nil: it is in limbo; `up_to_date`: it is not stale.
Index stale_source(const Context& x, Index group) {
  for (;;) {
    const GroupAssignment& now = x.s.now[group];
    if (now.granted()) return x.s.group_marks[group].has(mark::stale) ? group : up_to_date;
    if (is_limbo(x, now.holder)) return nil;
    group = requester(x, now.holder); // held only as a need: stale if its requester is
    if (group == nil) return up_to_date;
  }
}

/// If one of the current members was not granted before, they wait for their requester, which is stale: they are left
/// queued as before, unless they hold their target as a need from now on. False: all were granted.
bool wait_for_requester(Context& x, Index count) {
  if (!any(members(x, count), [&](const TriedMember& member) { return !was_granted(x, member.edge); })) return false;
  x.depends_on_requester = true;
  for (Index at = 0; at < count; ++at) {
    const Index edge = x.s.member[at].edge, group = target(x, edge);
    x.s.edge_marks[edge] |= mark::refused;
    if (x.s.queued[edge].why == Why::none || (holder_now(x, group) == edge && x.s.last[group].holder != edge))
      x.s.queued[edge] = {Why::outdated, nil};
  }
  keep_pushes(x, count);
  return true;
}

/// Grants again the members that were granted, and defers the others until the stale groups before them have run.
void defer(Context& x, Index count) {
  for (Index i = 0; i < count; ++i) {
    x.s.member[0].edge = x.s.unit[i];
    if (was_granted(x, x.s.member[0].edge) && combine(x, 1, true)) {
      grant(x, 1);
    } else {
      keep_pushes(x, 1);
      leave_queued(x, 1, Why::deferred);
    }
  }
}

/// As premature(), if any group is stale.
bool takes_from_stale(Context& x, Index count) {
  for (Index at = 0; at < count; ++at) {
    const Index edge = x.s.member[at].edge;
    if (was_granted(x, edge)) continue;
    Index found = 0;
    x.s.reach[found++] = target(x, edge);
    for (const PlanEntry& entry : plan_of(x, at)) x.s.reach[found++] = entry.group;
    if (reached_from_stale(x, found, edge)) return true;
  }
  return false;
}

/// Whether a granted stale group may request a group in `reach`, directly or not. With an edge: only a stale group that
/// goes before it and is not above it.
bool reached_from_stale(Context& x, Index found, Index edge) {
  const auto is_such = [&](Index group) {
    if (!x.s.now[group].granted() || !is_marked_stale(x, group) || holder_now(x, group) == nil) return false;
    const Index holder = x.s.now[group].holder;
    return edge == nil || (!in_chain(x, holder, {edge, Chains::current}) &&
                           before(x, {holder, Chains::current}, {edge, Chains::current}));
  };
  for (Index i = 0; i < found; ++i) x.s.group_marks[x.s.reach[i]] |= mark::reached; // they are not held, so not stale
  bool yes = false;
  for (Index i = 0; i < found && !yes; ++i) {
    for (const Index up : x.t.list(x.t.groups[x.s.reach[i]].requesters)) {
      const Index group = x.t.edges[up].requester;
      if (group == nil || x.s.group_marks[group].has(mark::reached)) continue;
      x.s.group_marks[group] |= mark::reached;
      x.s.reach[found++] = group;
      if (!is_such(group)) continue;
      x.s.run_queue[group].stale_matters = 1;
      yes = true;
      break;
    }
  }
  for (Index i = 0; i < found; ++i) x.s.group_marks[x.s.reach[i]].remove(mark::reached);
  x.work += found / walked_a_unit;
  return yes;
}

/// Whether the group, if it is granted, becomes stale: it has a reason to run that may change its requests.
bool becomes_stale(const Context& x, Index group) {
  const Index holder = x.s.last[group].holder;
  return x.s.run_queue[group].pending.has(reason::makes_stale) ||
         (holder != nil && !is_limbo(x, holder) && x.s.anew[holder] != 0);
}

} // namespace director::arbitration
