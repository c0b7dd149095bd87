// docs/semantics.md, section 4.3: how a group can be granted to an edge: a provider whose conditions hold, and a plan.
// SPDX-License-Identifier: MIT
//
// A plan is searched, not enumerated: it is a stack of entries (group, provider, who needs it), extended depth first;
// the next plan changes the last entry that has another provider. The plans of all members of a unit lie on one stack,
// one behind the other.

#include "runtime/core/arbitration/choices.hpp"

#include "runtime/core/arbitration/availability.hpp"
#include "runtime/core/arbitration/push.hpp"
#include "runtime/core/arbitration/staleness.hpp"

namespace director::arbitration {

/// Where the plan of `owner` keeps the provider picked for `group`; nil where it has only one.
Index slot_of(const Context& x, Index owner, Index group) {
  const Range slots = x.t.groups[owner].slots;
  for (Index slot = slots.begin; slot != slots.end; ++slot) {
    if (x.t.plan_groups[slot] == group) return slot;
  }
  return nil;
}

void drop_entries(Context& x, Index begin, Index end) {
  for (Index i = end; i-- > begin;) x.s.trial[x.s.entry_group[i]] = nil;
}

/// The first plan (`fresh`) or the next one of a provider whose group is marked in `trial`, as entries [begin, end).
/// The next plan changes the last entry that has another provider. Then an entry is added for each need that is still
/// open, depth first; a group cannot be held for two purposes.
bool search_plan(Context& x, Index provider, Index begin, Index& end, bool fresh, bool by_declaration) {
  const auto pick = [&](Index entry) {
    const Index group = x.s.entry_group[entry], choice = x.s.entry_choice[entry];
    x.s.entry_provider[entry] = by_declaration ? static_cast<Index>(x.t.groups[group].providers.begin + choice)
                                               : preferred(x, group, choice, x.s.entry_need[entry]);
  };
  if (fresh) end = begin;
  for (bool back = !fresh;;) {
    while (back) {
      if (injected(Fault::only_the_first_plan) && !fresh) drop_entries(x, begin, end), end = begin;
      if (end == begin) return false;
      const auto last = static_cast<Index>(end - 1);
      if (++x.s.entry_choice[last] < x.t.groups[x.s.entry_group[last]].providers.size()) {
        pick(last);
        back = false;
      } else {
        x.s.trial[x.s.entry_group[last]] = nil;
        --end;
      }
    }
    Index parent = end == begin ? nil : static_cast<Index>(end - 1); // whose need is to be met next, and which one
    Index place = 0;
    const auto needs = [&] { return x.t.providers[parent == nil ? provider : x.s.entry_provider[parent]].needs; };
    while (place >= needs().size()) {
      if (parent == nil) return true;
      place = static_cast<Index>(x.s.entry_place[parent] + 1);
      parent = x.s.entry_parent[parent];
    }
    const Index need = x.t.list(needs())[place], group = x.t.edges[need].target;
    if (x.s.trial[group] != nil) {
      back = true;
      continue;
    }
    x.s.trial[group] = need;
    x.s.entry_group[end] = group;
    x.s.entry_need[end] = need;
    x.s.entry_choice[end] = 0;
    x.s.entry_parent[end] = parent;
    x.s.entry_place[end] = place;
    pick(end++);
  }
}

/// The plan of `owner` for its provider is entries [begin, end).
void plan_for(Context& x, Index owner, Index provider, Index begin, Index end) {
  const Range slots = x.t.groups[owner].slots;
  x.s.now[owner].planned = provider;
  for (Index slot = slots.begin; slot != slots.end; ++slot) x.s.now.plan[slot] = nil;
  if (slots.empty()) return;
  for (Index i = begin; i < end; ++i) {
    const Index slot = slot_of(x, owner, x.s.entry_group[i]);
    if (slot != nil) x.s.now.plan[slot] = x.s.entry_provider[i];
  }
}

/// Every group of a plan is needed from now on; one that is not granted has the part of the plan that it needs.
void claim_plan(Context& x, Index begin, Index end) {
  for (Index i = begin; i < end; ++i) {
    const Index group = x.s.entry_group[i];
    x.s.now[group].flags |= flag::needed;
    if ((x.s.now[group].flags & flag::granted) != 0) continue;
    auto below = static_cast<Index>(i + 1); // depth first: what an entry needs stands right behind it
    while (below < end && x.s.entry_parent[below] != nil && x.s.entry_parent[below] >= i) ++below;
    plan_for(x, group, x.s.entry_provider[i], static_cast<Index>(i + 1), below);
  }
}

/// Writes the plan that a group has as entries from 0 on; returns how many.
Index entries_of(Context& x, Index group, const Assignment& of) {
  const Index planned = of[group].planned;
  if (planned == nil) return 0;
  Index end = 0;
  for (Index parent = nil;;) {
    Index place = 0;
    Index owner = parent;
    Index needer = parent == nil ? planned : x.s.entry_provider[parent];
    while (place >= x.t.providers[needer].needs.size()) { // the next need, depth first
      if (owner == nil) return end;
      place = static_cast<Index>(x.s.entry_place[owner] + 1);
      owner = x.s.entry_parent[owner];
      needer = owner == nil ? planned : x.s.entry_provider[owner];
    }
    const Index need = x.t.list(x.t.providers[needer].needs)[place], needed = x.t.edges[need].target;
    const Index slot = slot_of(x, group, needed);
    x.s.entry_group[end] = needed;
    x.s.entry_need[end] = need;
    x.s.entry_provider[end] = slot == nil ? x.t.groups[needed].providers.begin : of.plan[slot];
    x.s.entry_parent[end] = owner;
    x.s.entry_place[end] = place;
    parent = end++;
  }
}

namespace {

/// The plan in hand is the one that the member's target has.
bool plan_as_it_is(const Context& x, Index at) {
  const Index owner = target(x, x.s.member[at]);
  for (Index i = entries_begin(x, at); i < x.s.member_entries[at]; ++i) {
    const Index slot = slot_of(x, owner, x.s.entry_group[i]);
    if (slot != nil && x.s.last.plan[slot] != x.s.entry_provider[i]) return false;
  }
  return true;
}

/// Can the plan in hand be claimed, and do its conditions hold? `keep`: how many entries the next plan to try may
/// share.
bool plan_fits(Context& x, Index at, bool with_conditions, bool record, Index& keep) {
  const Index begin = entries_begin(x, at), end = x.s.member_entries[at];
  keep = end;
  for (Index i = begin; i < end; ++i) {
    if (x.s.enabled[x.s.entry_provider[i]] != 0 && available(x, x.s.entry_group[i], x.s.entry_need[i], record))
      continue;
    keep = static_cast<Index>(i + 1);
    return false;
  }
  for (Index i = begin; with_conditions && i < end; ++i) {
    if (first_false(x, x.s.entry_provider[i], x.s.entry_need[i]) != nil) return false;
  }
  return true;
}

} // namespace

/// The provider at a place in the order of preference that holds for `edge`.
Index preferred(const Context& x, Index group, Index place, Index edge) {
  const Index begin = x.t.groups[group].providers.begin;
  const Index first = pushed_first(x, group, edge);
  if (first == nil) return static_cast<Index>(begin + place);
  if (place == 0) return first;
  const auto usual = static_cast<Index>(begin + place - 1);
  return usual < first ? usual : static_cast<Index>(usual + 1);
}

/// It was active for its granted group after the last pass, and all of its `stay` holds: then its `when` does not
/// count.
bool stays(const Context& x, Index provider) {
  const Provider& row = x.t.providers[provider];
  if (row.stay.empty() || injected(Fault::stay_is_ignored)) return false;
  x.depends_on_last = true;
  if (x.s.last[row.group].active != provider || (x.s.last[row.group].flags & flag::granted) == 0) return false;
  for (const Index condition : x.t.list(row.stay)) {
    if (!holds(x, condition)) return false;
  }
  return true;
}

/// Held in this provider on purpose: conditions on states that it causes itself do not count.
bool waived(const Context& x, Index provider, Index condition, Index edge) {
  const Index group = x.t.providers[provider].group;
  const Push& push = x.s.now[group].push;
  if (injected(Fault::nothing_is_waived)) return false;
  if (push.edge == nil || push.provider != provider || (x.s.last[group].flags & flag::in_force) == 0 ||
      x.s.last[group].push.provider != provider)
    return false;
  for (const Index state : x.t.list(x.t.providers[provider].causing)) {
    if (state == x.t.conditions[condition].state) return applies(x, push, edge);
  }
  return false;
}

/// The first condition that keeps the provider from running for an edge, or nil.
Index first_false(const Context& x, Index provider, Index edge) {
  if (stays(x, provider)) return nil;
  for (const Index condition : x.t.list(x.t.providers[provider].when)) {
    if (!holds(x, condition) && !waived(x, provider, condition, edge)) return condition;
  }
  return nil;
}

/// The first (`fresh`) or next choice of a member of the unit: its provider and its plan's entries. False: no more, and
/// nothing of it is marked.
bool next_choice(Context& x, Index at, bool fresh, bool with_conditions, bool record) {
  const Index edge = x.s.member[at], group = target(x, edge);
  const bool as_it_is = stale_requester(x, edge); // also no other provider or plan
  const Range providers = x.t.groups[group].providers;
  Index& place = x.s.member_choice[at];
  Index& provider = x.s.member_provider[at];
  Index& end = x.s.member_entries[at];
  const Index begin = entries_begin(x, at);
  bool found = false;
  if (fresh) {
    if (x.s.trial[group] != nil || !available(x, group, edge, record)) return false;
    x.s.trial[group] = edge;
    place = 0;
  } else {
    found = search_plan(x, provider, begin, end, false, false);
    if (!found) ++place;
    ++x.work;
  }
  for (; place < providers.size(); ++place) {
    if (!found) {
      provider = preferred(x, group, place, edge);
      if ((x.s.enabled[provider] == 0 && !injected(Fault::disabled_providers_run)) ||
          (as_it_is && provider != x.s.last[group].active))
        continue;
      if (with_conditions && first_false(x, provider, edge) != nil) continue;
      found = search_plan(x, provider, begin, end, true, false);
    }
    ++x.work;
    while (found) {
      ++x.work;
      Index keep = end;
      if (!(as_it_is && !plan_as_it_is(x, at)) && plan_fits(x, at, with_conditions, record, keep)) return true;
      drop_entries(x, keep, end);
      end = keep;
      found = search_plan(x, provider, begin, end, false, false);
    }
  }
  x.s.trial[group] = nil;
  return false;
}

} // namespace director::arbitration
