// docs/semantics.md, section 4.3: how groups can be granted to edges: a provider whose conditions hold, and a plan, for
// each. SPDX-License-Identifier: MIT
//
// A plan is searched, not enumerated: it is a stack of entries (group, provider, who needs it), extended depth first;
// the next plan changes the last entry that has another provider. The plans of all members of a unit lie on one stack,
// one behind the other.

#include "runtime/core/arbitration/choices.hpp"

#include "runtime/core/arbitration/availability.hpp"
#include "runtime/core/arbitration/push.hpp"
#include "runtime/core/arbitration/staleness.hpp"
#include "runtime/core/base/parts.hpp"

namespace director::part {
const char search = 0;
}

namespace director::arbitration {

/// The first plan (`fresh`) or the next one of a provider whose group is marked in `trial`, as entries [begin, end).
/// The next plan changes the last entry that has another provider. Then an entry is added for each need that is still
/// open, depth first; a group cannot be held for two purposes.
bool search_plan(Context& x, Index provider, Index begin, Index& end, bool fresh, bool by_declaration) {
  const auto pick = [&](Index entry) {
    const Index group = x.s.entry[entry].group, choice = x.s.entry[entry].choice;
    x.s.entry[entry].provider = by_declaration ? static_cast<Index>(x.t.groups[group].providers.begin + choice)
                                               : preferred(x, group, choice, x.s.entry[entry].need);
  };
  if (fresh) end = begin;
  for (bool back = !fresh;;) {
    while (back) {
      if (injected(Fault::only_the_first_plan) && !fresh) drop_entries(x, begin, end), end = begin;
      if (end == begin) return false;
      const auto last = static_cast<Index>(end - 1);
      if (++x.s.entry[last].choice < x.t.groups[x.s.entry[last].group].providers.size()) {
        pick(last);
        back = false;
      } else {
        x.s.trial[x.s.entry[last].group] = nil;
        --end;
      }
    }
    Index parent = end == begin ? nil : static_cast<Index>(end - 1); // whose need is to be met next, and which one
    Index place = 0;
    const auto needs = [&] { return x.t.providers[parent == nil ? provider : x.s.entry[parent].provider].needs; };
    while (place >= needs().size()) {
      if (parent == nil) return true;
      place = static_cast<Index>(x.s.entry[parent].place + 1);
      parent = x.s.entry[parent].parent;
    }
    const Index need = x.t.list(needs())[place], group = x.t.edges[need].target;
    if (x.s.trial[group] != nil) {
      back = true;
      continue;
    }
    x.s.trial[group] = need;
    x.s.entry[end].group = group;
    x.s.entry[end].need = need;
    x.s.entry[end].choice = 0;
    x.s.entry[end].parent = parent;
    x.s.entry[end].place = place;
    pick(end++);
  }
}

namespace {

/// The plan in hand is the one that the member's target has.
bool plan_as_it_is(const Context& x, Index at) {
  const Index owner = target(x, x.s.member[at].edge);
  for (Index i = entries_begin(x, at); i < x.s.member[at].entries_end; ++i) {
    const Index slot = slot_of(x, owner, x.s.entry[i].group);
    if (slot != nil && x.s.last.plan[slot] != x.s.entry[i].provider) return false;
  }
  return true;
}

/// Can the plan in hand be claimed, and do its conditions hold? `keep`: how many entries the next plan to try may
/// share.
bool plan_fits(Context& x, Index at, bool with_conditions, bool record, Index& keep) {
  const Index begin = entries_begin(x, at), end = x.s.member[at].entries_end;
  keep = end;
  for (Index i = begin; i < end; ++i) {
    if (x.s.enabled[x.s.entry[i].provider] != 0 && available(x, x.s.entry[i].group, x.s.entry[i].need, record))
      continue;
    keep = static_cast<Index>(i + 1);
    return false;
  }
  for (Index i = begin; with_conditions && i < end; ++i) {
    if (first_false(x, x.s.entry[i].provider, x.s.entry[i].need) != nil) return false;
  }
  return true;
}

/// The first (`fresh`) or next choice of a member of the unit: its provider and its plan's entries. False: no more, and
/// nothing of it is marked.
bool next_choice(Context& x, Index at, bool fresh, bool with_conditions, bool record) {
  const Index edge = x.s.member[at].edge, group = target(x, edge);
  const bool as_it_is = stale_requester(x, edge); // also no other provider or plan
  const Range providers = x.t.groups[group].providers;
  Index& place = x.s.member[at].choice;
  Index& provider = x.s.member[at].provider;
  Index& end = x.s.member[at].entries_end;
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

/// What can claim the same group stands together, so that its choices are combined with each other and no others. The
/// first combination is the same: that of one cluster does not depend on another.
void sort_by_cluster(Context& x, Index count) {
  for (Index i = 1; i < count; ++i) {
    const Index edge = x.s.member[i].edge, cluster = x.t.cluster(edge);
    Index at = i;
    for (; at > 0 && x.t.cluster(x.s.member[at - 1].edge) > cluster; --at)
      x.s.member[at].edge = x.s.member[at - 1].edge;
    x.s.member[at].edge = edge;
  }
}

/// Of the members in order, up to the first one that has none. `record`: all choices of each, for whose sake they are
/// denied.
bool each_has_choice(Context& x, Index from, Index count, bool with_conditions, bool record) {
  for (Index at = from; at < count; ++at) {
    // Alone on the stack: entries_begin(x) of a later member is where the earlier one ends.
    if (at > 0) x.s.member[at - 1].entries_end = 0;
    bool any = false;
    for (bool fresh = true; next_choice(x, at, fresh, with_conditions, record); fresh = false) {
      any = true;
      if (record) continue;
      drop_entries(x, 0, x.s.member[at].entries_end);
      x.s.trial[target(x, x.s.member[at].edge)] = nil;
      break;
    }
    if (!any) return false;
  }
  return true;
}

} // namespace

/// Lexicographically over the members. Which holders stood in the way counts over all choices of each member, also
/// those that are never needed: so, where there can be any, each member's are looked at once, and then combined.
bool search_combination(Context& x, Index count, bool with_conditions) {
  if (count == 1 && x.t.groups[target(x, x.s.member[0].edge)].single_choice())
    return next_choice(x, 0, true, with_conditions, true);
  bool deniable = false;
  for (Index at = 0; at < count && !deniable; ++at) deniable = x.row.equals && may_be_denied(x, x.s.member[at].edge);
  if (deniable && !each_has_choice(x, 0, count, with_conditions, true)) return false;
  Index at = 0;
  bool fresh = true, known = deniable; // that each has a choice for itself
  bool sorted = false;                 // by cluster
  for (;;) {
    if (next_choice(x, at, fresh, with_conditions, false)) {
      if (at + 1 == count) return true;
      ++at;
      fresh = true;
    } else if (at == 0) {
      return false;
    } else if (sorted) {
      if (x.t.cluster(x.s.member[at - 1].edge) !=
          x.t.cluster(x.s.member[at].edge)) { // no choice of another cluster helps
        leave_combination(x, at);
        return false;
      }
      --at;
      fresh = false;
    } else { // before all choices of those before it are tried with one that has none: a sum and no product
      leave_combination(x, at);
      if (!known && !each_has_choice(x, at, count, with_conditions, false)) return false; // those before it have one
      sort_by_cluster(x, count);
      sorted = true;
      at = 0;
      fresh = true;
    }
  }
}

} // namespace director::arbitration
