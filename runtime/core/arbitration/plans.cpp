// docs/semantics.md, section 4.3, plans: a provider for each group that a provider needs, directly or not.
// SPDX-License-Identifier: MIT
//
// A plan is searched, not enumerated: it is a stack of entries (group, provider, need), extended depth first; the next
// plan changes the last entry that has another provider. The plans of a unit are on one stack, one behind the other.

#include "runtime/core/arbitration/grant.hpp"
#include "runtime/core/arbitration/push.hpp"

const char director::part::plans = 0;

namespace director::arbitration {

namespace {

/// Adds the first need that the entries of a plan for a provider do not meet, depth first. False: they meet all.
bool next_need(const Context& x, Index provider, Index begin, Index end) {
  Index parent = end == begin ? nil : static_cast<Index>(end - 1), place = 0;
  for (;;) {
    const Range needs = x.t.providers[parent == nil ? provider : x.s.entry[parent].provider].needs;
    if (place < needs.size()) {
      const Index need = x.t.list(needs)[place];
      x.s.entry[end] = {
          .group = target(x, need), .need = need, .choice = 0, .provider = nil, .parent = parent, .place = place};
      return true;
    }
    if (parent == nil) return false;
    place = static_cast<Index>(x.s.entry[parent].place + 1);
    parent = x.s.entry[parent].parent;
  }
}

void pick(Context& x, PlanEntry& entry, bool by_declaration) {
  entry.provider = by_declaration ? static_cast<Index>(x.t.groups[entry.group].providers.begin + entry.choice)
                                  : preferred(x, entry.group, entry.choice, entry.need);
}

/// Changes the last entry that has another provider, and drops those behind it. False: none has.
bool change_last(Context& x, Index begin, Index& end, bool by_declaration) {
  for (; end != begin; --end) {
    PlanEntry& last = x.s.entry[end - 1];
    if (++last.choice < x.t.groups[last.group].providers.size()) {
      pick(x, last, by_declaration);
      return true;
    }
    x.s.trial[last.group] = nil;
  }
  return false;
}

/// Whether the current plan is the one that the member's target has.
bool plan_as_it_is(const Context& x, Index at) {
  const Index owner = target(x, x.s.member[at].edge);
  return !any(plan_of(x, at), [&](const PlanEntry& entry) {
    const Index slot = slot_of(x, owner, entry.group);
    return slot != nil && x.s.last.plan[slot] != entry.provider;
  });
}

/// Whether the current plan can be claimed, and its conditions hold. `keep`: how many entries the next plan may share.
bool plan_fits(Context& x, Index at, bool with_conditions, bool record, Index& keep) {
  const Index begin = entries_begin(x, at), end = x.s.member[at].entries_end;
  keep = end;
  for (Index i = begin; i < end; ++i) {
    if (x.s.enabled[x.s.entry[i].provider] != 0 && available(x, x.s.entry[i].group, x.s.entry[i].need, record))
      continue;
    keep = static_cast<Index>(i + 1);
    return false;
  }
  return !with_conditions || !any(plan_of(x, at), [&](const PlanEntry& entry) {
    return first_false(x, entry.provider, entry.need) != nil;
  });
}

/// Makes entries [begin, end) the plan of `owner` for its provider.
void plan_for(Context& x, Index owner, Index provider, Index begin, Index end) {
  const Range slots = x.t.groups[owner].slots;
  x.s.now[owner].planned = provider;
  for (const Index slot : slots.rows()) x.s.now.plan[slot] = nil;
  if (slots.empty()) return;
  for (Index i = begin; i < end; ++i) {
    const Index slot = slot_of(x, owner, x.s.entry[i].group);
    if (slot != nil) x.s.now.plan[slot] = x.s.entry[i].provider;
  }
}

} // namespace

/// Finds the first plan (`fresh`) or the next one of a provider whose group is marked in `trial`, as entries [begin,
/// end). An entry is added for each need that is still open, depth first; a group cannot be held for two needs.
bool search_plan(Context& x, Index provider, Index begin, Index& end, bool fresh, bool by_declaration) {
  if (fresh) end = begin;
  if (!fresh && !change_last(x, begin, end, by_declaration)) return false;
  while (next_need(x, provider, begin, end)) {
    PlanEntry& added = x.s.entry[end];
    if (x.s.trial[added.group] == nil && !taken(x, added.need)) {
      x.s.trial[added.group] = added.need;
      pick(x, added, by_declaration);
      ++end;
    } else {
      ++x.work; // no plan with this beginning can be claimed
      if (!change_last(x, begin, end, by_declaration)) return false;
    }
  }
  return true;
}

/// Finds the first or next plan of the provider that can be claimed, with conditions. `as_it_is`: only the last.
bool find_plan(Context& x, Index at, bool first, bool as_it_is, bool with_conditions, bool record) {
  const Index provider = x.s.member[at].provider, begin = entries_begin(x, at);
  Index& end = x.s.member[at].entries_end;
  while (search_plan(x, provider, begin, end, first, false)) {
    first = false;
    ++x.work;
    Index keep = end;
    const bool other = as_it_is && !plan_as_it_is(x, at);
    x.depends_on_requester = x.depends_on_requester || other;
    if (!other && plan_fits(x, at, with_conditions, record, keep)) return true;
    drop_entries(x, keep, end);
    end = keep;
  }
  return false;
}

/// Whether other edges have claimed a need of each provider of the group that is enabled.
bool needs_claimed(const Context& x, Index group) {
  return !any(x.t.groups[group].providers.rows(), [&](Index p) {
    return x.s.enabled[p] != 0 && !any(x.t.list(x.t.providers[p].needs), [&](Index need) { return taken(x, need); });
  });
}

/// As plan_for, and claims every group of the plan as needed. One that is not granted gets its own part of the plan.
void claim_plan(Context& x, Index owner, Index provider, Index begin, Index end) {
  plan_for(x, owner, provider, begin, end);
  for (Index i = begin; i < end; ++i) {
    const Index group = x.s.entry[i].group;
    claim(x, group, x.s.entry[i].need);
    x.s.now[group].flags |= flag::needed;
    if (x.s.now[group].granted()) continue;
    auto below = static_cast<Index>(i + 1); // the needs of an entry are right behind it
    while (below < end && x.s.entry[below].parent != nil && x.s.entry[below].parent >= i) ++below;
    plan_for(x, group, x.s.entry[i].provider, static_cast<Index>(i + 1), below);
  }
}

/// Writes the plan of a group as entries from 0 on; returns their number.
Index entries_of(Context& x, Index group, const Assignment& of) {
  const Index planned = of[group].planned;
  Index end = 0;
  while (planned != nil && next_need(x, planned, 0, end)) {
    const Index needed = x.s.entry[end].group, slot = slot_of(x, group, needed);
    x.s.entry[end++].provider = slot == nil ? x.t.groups[needed].providers.begin : of.plan[slot];
  }
  return end;
}

} // namespace director::arbitration
