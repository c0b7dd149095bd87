// Door: runtime/core/arbitration/arbitration.hpp. Test: tests/runtime/core/arbitration/arbitration_test.cpp.
// SPDX-License-Identifier: MIT
//
// Sections 4.2 and 4.3: what is available, and how a group can be granted to an edge. A plan is searched, not
// enumerated: it is a stack of entries (group, provider, who needs it), extended depth first; the next plan changes the
// last entry that has another provider. The plans of all members of a unit lie on one stack, one behind the other.

#include "runtime/core/arbitration/arbitration.hpp"
#include "runtime/core/base/marks.hpp"
#include "runtime/core/base/fault_injection.hpp"

namespace director {

/// Requested or needed by its requester's active provider, whose own chain is alive up to root.
bool Pass::alive(Index edge) const {
  for (;;) {
    if (is_limbo(edge)) return false;
    const Index group = target(edge);
    const bool needed = s_.last[group].holder == edge && (s_.last[group].flags & flag::needed) != 0;
    if (!requested(edge) && !needed) return false;
    const Index from = requester(edge);
    if (from == nil) return true;
    edge = s_.last[from].holder;
    if (edge == nil) return false;
  }
}

/// Equals never take from each other. Its last holder is an edge, and another one.
bool Pass::kept_by_equal(Index group, Index edge, bool record) {
  if (!equals_) return false;
  const Index holder = s_.last[group].holder;
  if (injected(Fault::equals_take) || (s_.edge_marks[holder] & mark::refused) != 0 ||
      (s_.group_marks[group] & mark::forgotten) != 0 || !alive(holder) ||
      compare({edge, Chains::current}, {holder, Chains::previous}, false) != 0)
    return false;
  depends_on_last_ = depends_on_stale_ = true;
  if (record && (s_.group_marks[group] & mark::denied) == 0) {
    open(group);
    s_.group_marks[group] |= mark::denied;
    s_.denied[denied_++] = group;
  }
  return true;
}

/// The pusher goes before `edge`, and `edge` is not below it.
bool Pass::applies(const Push& push, Index edge) const {
  return push.edge != nil && before({push.edge, Chains::current}, {edge, Chains::current}) &&
         !in_chain(push.edge, {edge, Chains::current});
}

/// The provider that a push moves to the front for an edge that controls the group, or nil.
Index Pass::pushed_first(Index group, Index edge) const {
  const Push& push = s_.now[group].push;
  if (injected(Fault::pushes_move_nothing)) return nil;
  return push.edge != nil && applies(push, edge) ? push.provider : nil;
}

/// The provider at a place in the order of preference that holds for `edge`.
Index Pass::preferred(Index group, Index place, Index edge) const {
  const Index begin = t_.groups[group].providers.begin;
  const Index first = pushed_first(group, edge);
  if (first == nil) return static_cast<Index>(begin + place);
  if (place == 0) return first;
  const auto usual = static_cast<Index>(begin + place - 1);
  return usual < first ? usual : static_cast<Index>(usual + 1);
}

/// It was active for its granted group after the last pass, and all of its `stay` holds: then its `when` does not
/// count.
bool Pass::stays(Index provider) const {
  const Provider& row = t_.providers[provider];
  if (row.stay.empty() || injected(Fault::stay_is_ignored)) return false;
  depends_on_last_ = true;
  if (s_.last[row.group].active != provider || (s_.last[row.group].flags & flag::granted) == 0) return false;
  for (const Index condition : t_.list(row.stay)) {
    if (!holds(condition)) return false;
  }
  return true;
}

/// Held in this provider on purpose: conditions on states that it causes itself do not count.
bool Pass::waived(Index provider, Index condition, Index edge) const {
  const Index group = t_.providers[provider].group;
  const Push& push = s_.now[group].push;
  if (injected(Fault::nothing_is_waived)) return false;
  if (push.edge == nil || push.provider != provider || (s_.last[group].flags & flag::in_force) == 0 ||
      s_.last[group].push.provider != provider)
    return false;
  for (const Index state : t_.list(t_.providers[provider].causing)) {
    if (state == t_.conditions[condition].state) return applies(push, edge);
  }
  return false;
}

/// The first condition that keeps the provider from running for an edge, or nil.
Index Pass::first_false(Index provider, Index edge) const {
  if (stays(provider)) return nil;
  for (const Index condition : t_.list(t_.providers[provider].when)) {
    if (!holds(condition) && !waived(provider, condition, edge)) return condition;
  }
  return nil;
}

/// Where the plan of `owner` keeps the provider picked for `group`; nil where it has only one.
Index Pass::slot_of(Index owner, Index group) const {
  const Range slots = t_.groups[owner].slots;
  for (Index slot = slots.begin; slot != slots.end; ++slot) {
    if (t_.plan_groups[slot] == group) return slot;
  }
  return nil;
}

void Pass::drop_entries(Index begin, Index end) {
  for (Index i = end; i-- > begin;) s_.trial[s_.entry_group[i]] = nil;
}

/// The first plan (`fresh`) or the next one of a provider whose group is marked in `trial`, as entries [begin, end).
/// The next plan changes the last entry that has another provider. Then an entry is added for each need that is still
/// open, depth first; a group cannot be held for two purposes.
bool Pass::search_plan(Index provider, Index begin, Index& end, bool fresh, bool by_declaration) {
  const auto pick = [&](Index entry) {
    const Index group = s_.entry_group[entry], choice = s_.entry_choice[entry];
    s_.entry_provider[entry] = by_declaration ? static_cast<Index>(t_.groups[group].providers.begin + choice)
                                              : preferred(group, choice, s_.entry_need[entry]);
  };
  if (fresh) end = begin;
  for (bool back = !fresh;;) {
    while (back) {
      if (injected(Fault::only_the_first_plan) && !fresh) drop_entries(begin, end), end = begin;
      if (end == begin) return false;
      const auto last = static_cast<Index>(end - 1);
      if (++s_.entry_choice[last] < t_.groups[s_.entry_group[last]].providers.size()) {
        pick(last);
        back = false;
      } else {
        s_.trial[s_.entry_group[last]] = nil;
        --end;
      }
    }
    Index parent = end == begin ? nil : static_cast<Index>(end - 1); // whose need is to be met next, and which one
    Index place = 0;
    const auto needs = [&] { return t_.providers[parent == nil ? provider : s_.entry_provider[parent]].needs; };
    while (place >= needs().size()) {
      if (parent == nil) return true;
      place = static_cast<Index>(s_.entry_place[parent] + 1);
      parent = s_.entry_parent[parent];
    }
    const Index need = t_.list(needs())[place], group = t_.edges[need].target;
    if (s_.trial[group] != nil) {
      back = true;
      continue;
    }
    s_.trial[group] = need;
    s_.entry_group[end] = group;
    s_.entry_need[end] = need;
    s_.entry_choice[end] = 0;
    s_.entry_parent[end] = parent;
    s_.entry_place[end] = place;
    pick(end++);
  }
}

/// The plan in hand is the one that the member's target has.
bool Pass::plan_as_it_is(Index at) const {
  const Index owner = target(s_.member[at]);
  for (Index i = entries_begin(at); i < s_.member_entries[at]; ++i) {
    const Index slot = slot_of(owner, s_.entry_group[i]);
    if (slot != nil && s_.last.plan[slot] != s_.entry_provider[i]) return false;
  }
  return true;
}

/// Can the plan in hand be claimed, and do its conditions hold? `keep`: how many entries the next plan to try may
/// share.
bool Pass::plan_fits(Index at, bool with_conditions, bool record, Index& keep) {
  const Index begin = entries_begin(at), end = s_.member_entries[at];
  keep = end;
  for (Index i = begin; i < end; ++i) {
    if (s_.enabled[s_.entry_provider[i]] != 0 && available(s_.entry_group[i], s_.entry_need[i], record)) continue;
    keep = static_cast<Index>(i + 1);
    return false;
  }
  for (Index i = begin; with_conditions && i < end; ++i) {
    if (first_false(s_.entry_provider[i], s_.entry_need[i]) != nil) return false;
  }
  return true;
}

/// The first (`fresh`) or next choice of a member of the unit: its provider and its plan's entries. False: no more, and
/// nothing of it is marked.
bool Pass::next_choice(Index at, bool fresh, bool with_conditions, bool record) {
  const Index edge = s_.member[at], group = target(edge);
  const bool as_it_is = stale_requester(edge); // also no other provider or plan
  const Range providers = t_.groups[group].providers;
  Index& place = s_.member_choice[at];
  Index& provider = s_.member_provider[at];
  Index& end = s_.member_entries[at];
  const Index begin = entries_begin(at);
  bool found = false;
  if (fresh) {
    if (s_.trial[group] != nil || !available(group, edge, record)) return false;
    s_.trial[group] = edge;
    place = 0;
  } else {
    found = search_plan(provider, begin, end, false, false);
    if (!found) ++place;
    ++work_;
  }
  for (; place < providers.size(); ++place) {
    if (!found) {
      provider = preferred(group, place, edge);
      if ((s_.enabled[provider] == 0 && !injected(Fault::disabled_providers_run)) ||
          (as_it_is && provider != s_.last[group].active))
        continue;
      if (with_conditions && first_false(provider, edge) != nil) continue;
      found = search_plan(provider, begin, end, true, false);
    }
    ++work_;
    while (found) {
      ++work_;
      Index keep = end;
      if (!(as_it_is && !plan_as_it_is(at)) && plan_fits(at, with_conditions, record, keep)) return true;
      drop_entries(keep, end);
      end = keep;
      found = search_plan(provider, begin, end, false, false);
    }
  }
  s_.trial[group] = nil;
  return false;
}

} // namespace director
