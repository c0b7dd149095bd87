// docs/semantics.md, section 4.4, Grant: the first combination of choices of a unit in which all claims are compatible.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/choices.hpp"

#include "runtime/core/arbitration/availability.hpp"
#include "runtime/core/arbitration/order.hpp"
#include "runtime/core/arbitration/staleness.hpp"

namespace director::arbitration {

namespace {

/// The plan of a provider of a flat group, as entries; false: it cannot be claimed, or a condition of it is false.
bool take_needs(Context& x, Index provider, bool with_conditions) {
  Index end = 0;
  bool fits = true;
  for (const Index need : x.t.list(x.t.providers[provider].needs)) {
    const Index group = x.t.edges[need].target, its_provider = x.t.groups[group].providers.begin;
    fits = x.s.trial[group] == nil && x.s.enabled[its_provider] != 0 && !taken(x, need);
    if (!fits) break;
    x.s.trial[group] = need;
    x.s.entry_group[end] = group;
    x.s.entry_need[end] = need;
    x.s.entry_provider[end] = its_provider;
    x.s.entry_parent[end] = nil;
    ++end;
  }
  for (Index i = 0; with_conditions && fits && i < end; ++i)
    fits = first_false(x, x.s.entry_provider[i], x.s.entry_need[i]) == nil;
  if (!fits) drop_entries(x, 0, end);
  x.s.member_entries[0] = end;
  return fits;
}

/// The first choice of the one member in hand, where its target is flat (each provider has one plan, whose groups have
/// one provider and need nothing) and no equal stands in the way: the same as next_choice with nothing to search.
bool choose_flat(Context& x, bool with_conditions) {
  const Index edge = x.s.member[0], group = x.t.edges[edge].target;
  if (taken(x, edge)) return false;
  const bool as_it_is = stale_requester(x, edge);
  const Range providers = x.t.groups[group].providers;
  x.s.trial[group] = edge;
  for (Index place = 0; place < providers.size(); ++place) {
    ++x.work;
    const Index provider = preferred(x, group, place, edge);
    if (x.s.enabled[provider] == 0 && !injected(Fault::disabled_providers_run)) continue;
    if (as_it_is && provider != x.s.last[group].active) continue;
    if (with_conditions && first_false(x, provider, edge) != nil) continue;
    if (!take_needs(x, provider, with_conditions)) continue;
    x.s.member_provider[0] = provider;
    return true;
  }
  x.s.trial[group] = nil;
  return false;
}

/// What can claim the same group stands together, so that its choices are combined with each other and no others. The
/// first combination is the same: that of one cluster does not depend on another.
void sort_by_cluster(Context& x, Index count) {
  for (Index i = 1; i < count; ++i) {
    const Index edge = x.s.member[i], cluster = x.t.cluster(edge);
    Index at = i;
    for (; at > 0 && x.t.cluster(x.s.member[at - 1]) > cluster; --at) x.s.member[at] = x.s.member[at - 1];
    x.s.member[at] = edge;
  }
}

/// Of the members in order, up to the first one that has none. `record`: all choices of each, for whose sake they are
/// denied.
bool each_has_choice(Context& x, Index from, Index count, bool with_conditions, bool record) {
  for (Index at = from; at < count; ++at) {
    // Alone on the stack: entries_begin(x) of a later member is where the earlier one ends.
    if (at > 0) x.s.member_entries[at - 1] = 0;
    bool any = false;
    for (bool fresh = true; next_choice(x, at, fresh, with_conditions, record); fresh = false) {
      any = true;
      if (record) continue;
      drop_entries(x, 0, x.s.member_entries[at]);
      x.s.trial[target(x, x.s.member[at])] = nil;
      break;
    }
    if (!any) return false;
  }
  return true;
}

} // namespace

/// The first combination of choices, lexicographically over the members, in which all claims are compatible. True: it
/// is in hand (member_*, entry_*, trial) until leave_combination. Which holders stood in the way counts over all
/// choices of each member, also those that are never needed: so, where there can be any, each member's are looked at
/// once, and then combined.
bool combine(Context& x, Index count, bool with_conditions) {
  for (Index i = 0; count > 1 && i < count; ++i) x.s.member[i] = x.s.unit[i];
  if (count == 1 && x.t.groups[target(x, x.s.member[0])].flat && !x.disputed)
    return choose_flat(x, with_conditions);
  if (count == 1 && x.t.groups[target(x, x.s.member[0])].single_choice())
    return next_choice(x, 0, true, with_conditions, true);
  bool deniable = false;
  for (Index at = 0; at < count && !deniable; ++at) deniable = may_be_denied(x, x.s.member[at]);
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
      if (x.t.cluster(x.s.member[at - 1]) != x.t.cluster(x.s.member[at])) { // no choice of another cluster helps
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

void leave_combination(Context& x, Index count) {
  if (count == 0) return;
  drop_entries(x, 0, x.s.member_entries[count - 1]);
  for (Index at = 0; at < count; ++at) x.s.trial[target(x, x.s.member[at])] = nil;
}

} // namespace director::arbitration
