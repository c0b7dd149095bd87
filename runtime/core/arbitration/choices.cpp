// docs/semantics.md, section 4.3: how a group can be granted to an edge: a provider whose conditions hold, and a plan.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/choices.hpp"

#include "runtime/core/arbitration/availability.hpp"
#include "runtime/core/arbitration/order.hpp"
#include "runtime/core/arbitration/plan.hpp"
#include "runtime/core/arbitration/push.hpp"
#include "runtime/core/arbitration/staleness.hpp"
#include "runtime/core/base/fault_injection.hpp"

namespace director::arbitration {

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
