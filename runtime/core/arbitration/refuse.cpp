// docs/semantics.md, sections 4.3 and 4.4, Refuse: the conditions of a provider, and units that wait for one.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/grant.hpp"
#include "runtime/core/arbitration/push.hpp"

const char director::part::conditions = 0;

namespace director::arbitration {

namespace {

/// Whether a push in force waives the condition: it is on a state that the pushed provider causes itself.
bool waived(const Context& x, Index provider, Index condition, Index edge) {
  const Index group = x.t.providers[provider].group;
  if (x.s.now[group].push.provider != provider) return false;
  const Push push = push_so_far(x, group);
  x.depends_on_last = true;
  if (!x.s.last[group].in_force() || x.s.last[group].push.provider != provider) return false;
  return any(x.t.list(x.t.providers[provider].causing),
             [&](Index s) { return s == x.t.conditions[condition].state; }) &&
         applies(x, push, edge);
}

/// Whether `is` holds for one of the conditions that prevent the provider from running for an edge.
template <class Is>
bool any_false(const Context& x, Index provider, Index edge, const Is& is) {
  return (x.t.providers[provider].stay.empty() || !stays(x, provider)) &&
         any(x.t.list(x.t.providers[provider].when), [&](Index condition) {
           return !holds(x, condition) && !waived(x, provider, condition, edge) && is(condition);
         });
}

/// Collects the false conditions of the current combination, member by member: its provider's, then its plan's.
Index collect_unmet(Context& x, Index count) {
  Index found = 0;
  for (Index place = 0; place < count; ++place) { // in the order of the unit, which the search may have changed
    Index at = place;
    for (Index other = 0; count > 1 && x.s.member[at].edge != x.s.unit[place]; ++other) at = other;
    const TriedMember& member = x.s.member[at];
    const auto add = [&](Index condition) {
      x.s.unmet[found++] = {member.edge, condition};
      return false;
    };
    any_false(x, member.provider, member.edge, add);
    for (const PlanEntry& entry : plan_of(x, at)) any_false(x, entry.provider, entry.need, add);
  }
  return found;
}

} // namespace

/// Whether `stay` replaces `when`: all of it holds, and the provider was active for its granted group.
bool stays(const Context& x, Index provider) {
  const Provider& row = x.t.providers[provider];
  if (row.stay.empty()) return false;
  x.depends_on_last = true;
  if (x.s.last[row.group].active != provider || !x.s.last[row.group].granted()) return false;
  return !any(x.t.list(row.stay), [&](Index condition) { return !holds(x, condition); });
}

Index find_false(const Context& x, Index provider, Index edge) {
  Index first = nil;
  any_false(x, provider, edge, [&](Index condition) {
    first = condition;
    return true;
  });
  return first;
}

/// Refuses the current members: no combination is available with all its conditions true.
void refuse(Context& x, Index count) {
  for (const TriedMember& member : members(x, count)) x.s.edge_marks[member.edge] |= mark::refused;
  if (!combine(x, count, false)) return leave_queued(x, count, Why::blocked);
  x.depends_on_last = true;
  const Index unmet = collect_unmet(x, count);
  const bool below_stale = stale_requester(x, x.s.member[0].edge);
  x.depends_on_requester = x.depends_on_requester || below_stale;
  const bool early = below_stale || premature(x, count);
  x.depends_on_stale = x.depends_on_stale || early;
  leave_combination(x, count);
  leave_queued(x, count, Why::waiting, x.s.unmet[0].condition);
  if (early) return keep_pushes(x, count);
  const auto enabled = [&](Index provider) { return x.s.enabled[provider] != 0; };
  for (Index i = 0; i < unmet; ++i) { // if no provider can cause one of them, the unit pushes nothing
    if (!any(x.t.list(x.t.conditions[x.s.unmet[i].condition].causers), enabled)) return;
  }
  push_for(x, count, unmet);
}

} // namespace director::arbitration
