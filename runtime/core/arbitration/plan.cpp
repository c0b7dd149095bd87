// docs/semantics.md, section 4.3: need plans.
// SPDX-License-Identifier: MIT
//
// A plan is searched, not enumerated: it is a stack of entries (group, provider, who needs it), extended depth first;
// the next plan changes the last entry that has another provider. The plans of all members of a unit lie on one stack,
// one behind the other.

#include "runtime/core/arbitration/plan.hpp"

#include "runtime/core/arbitration/choices.hpp"
#include "runtime/core/base/fault_injection.hpp"

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

} // namespace director::arbitration
