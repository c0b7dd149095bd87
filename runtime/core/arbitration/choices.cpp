// docs/semantics.md, section 4.3: how a group can be granted to an edge: a provider whose conditions hold, and a plan.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/choices.hpp"

#include "runtime/core/arbitration/push.hpp"
#include "runtime/core/arbitration/staleness.hpp"

namespace director::arbitration {

/// Finds the first (`fresh`) or next choice of a member of the unit: its provider and the entries of its plan. False:
/// there is no other, and none of its groups is marked in `trial`.
bool next_choice(Context& x, Index at, bool fresh, bool with_conditions, bool record) {
  TriedMember& member = x.s.member[at];
  const Index edge = member.edge, group = target(x, edge);
  const bool as_it_is = stale_requester(x, edge); // it must not get another provider or plan
  if (fresh) {
    if (x.s.trial[group] != nil || !available(x, group, edge, record)) return false;
    x.s.trial[group] = edge;
    member.choice = 0;
  }
  const Index providers = x.t.groups[group].providers.size();
  for (bool first = fresh; member.choice < providers; ++member.choice, first = true) {
    if (first) {
      member.provider = preferred(x, group, member.choice, edge);
      if (x.s.enabled[member.provider] == 0) continue;
      if (with_conditions && first_false(x, member.provider, edge) != nil) continue;
      if (as_it_is && member.provider != x.s.last[group].active) {
        x.depends_on_requester = true;
        continue;
      }
      member.entries_end = entries_begin(x, at);
    }
    ++x.work;
    const bool needs = !x.t.providers[member.provider].needs.empty();
    if (needs ? find_plan(x, at, first, as_it_is, with_conditions, record) : first) return true;
  }
  x.s.trial[group] = nil;
  return false;
}

/// Finds the first combination of choices that are available together, the current one until leave_combination.
bool combine(Context& x, Index count, bool with_conditions) {
  const Group& group = x.t.groups[target(x, x.s.member[0].edge)];
  const bool first_counts = count == 1 && (!group.deniable || (group.providers.size() == 1 && group.slots.empty()));
  return first_counts ? next_choice(x, 0, true, with_conditions, true) : search_combination(x, count, with_conditions);
}

void leave_combination(Context& x, Index count) {
  if (count == 0) return;
  drop_entries(x, 0, x.s.member[count - 1].entries_end);
  for (const TriedMember& member : members(x, count)) x.s.trial[target(x, member.edge)] = nil;
}

} // namespace director::arbitration
