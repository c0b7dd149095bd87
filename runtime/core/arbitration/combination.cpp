// docs/semantics.md, section 4.4, Grant: the first combination of choices of a unit in which all claims are compatible.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/choices.hpp"
#include "runtime/core/arbitration/order.hpp"
#include "runtime/core/arbitration/push.hpp"
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
    x.s.entry[end].group = group;
    x.s.entry[end].need = need;
    x.s.entry[end].provider = its_provider;
    x.s.entry[end].parent = nil;
    ++end;
  }
  for (Index i = 0; with_conditions && fits && i < end; ++i)
    fits = first_false(x, x.s.entry[i].provider, x.s.entry[i].need) == nil;
  if (!fits) drop_entries(x, 0, end);
  x.s.member[0].entries_end = end;
  return fits;
}

/// The first choice of the one member in hand, where its target is flat (each provider has one plan, whose groups have
/// one provider and need nothing) and no equal stands in the way: the same as next_choice with nothing to search.
bool choose_flat(Context& x, bool with_conditions) {
  const Index edge = x.s.member[0].edge, group = x.t.edges[edge].target;
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
    x.s.member[0].provider = provider;
    return true;
  }
  x.s.trial[group] = nil;
  return false;
}

} // namespace

/// The first combination of choices in which all claims are compatible. True: it is in hand (member_*, entry_*, trial)
/// until leave_combination.
bool combine(Context& x, Index count, bool with_conditions) {
  for (Index i = 0; count > 1 && i < count; ++i) x.s.member[i].edge = x.s.unit[i];
  if (count == 1 && x.t.groups[target(x, x.s.member[0].edge)].flat && !x.disputed)
    return choose_flat(x, with_conditions);
  return search_combination(x, count, with_conditions);
}

void leave_combination(Context& x, Index count) {
  if (count == 0) return;
  drop_entries(x, 0, x.s.member[count - 1].entries_end);
  for (Index at = 0; at < count; ++at) x.s.trial[target(x, x.s.member[at].edge)] = nil;
}

} // namespace director::arbitration
