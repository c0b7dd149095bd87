// docs/semantics.md, section 4.3: how a group can be granted to an edge: a provider whose conditions hold, and a plan.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/choices.hpp"

#include "runtime/core/arbitration/availability.hpp"
#include "runtime/core/arbitration/push.hpp"
#include "runtime/core/arbitration/staleness.hpp"

namespace director::arbitration {

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
    found = end != begin && search_plan(x, provider, begin, end, false, false);
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
      end = begin;
      found = x.t.providers[provider].needs.empty() || search_plan(x, provider, begin, end, true, false);
    }
    ++x.work;
    while (found) {
      ++x.work;
      Index keep = end;
      if (end == begin || plan_fits(x, at, as_it_is, with_conditions, record, keep)) return true;
      drop_entries(x, keep, end);
      end = keep;
      found = end != begin && search_plan(x, provider, begin, end, false, false);
    }
  }
  x.s.trial[group] = nil;
  return false;
}

/// The first combination of choices in which all claims are compatible. True: it is in hand (member_*, entry_*, trial)
/// until leave_combination. Which holders stood in the way counts over all choices of each member, also those that are
/// never needed.
bool combine(Context& x, Index count, bool with_conditions) {
  for (Index i = 0; count > 1 && i < count; ++i) x.s.member[i].edge = x.s.unit[i];
  const bool single = count == 1 && x.t.groups[target(x, x.s.member[0].edge)].single_choice();
  bool deniable = false;
  for (Index at = 0; x.row.equals && !single && at < count && !deniable; ++at)
    deniable = may_be_denied(x, x.s.member[at].edge);
  return count == 1 && !deniable ? next_choice(x, 0, true, with_conditions, true)
                                 : search_combination(x, count, with_conditions, deniable);
}

void leave_combination(Context& x, Index count) {
  if (count == 0) return;
  drop_entries(x, 0, x.s.member[count - 1].entries_end);
  for (Index at = 0; at < count; ++at) x.s.trial[target(x, x.s.member[at].edge)] = nil;
}

} // namespace director::arbitration
