// Door: runtime/core/arbitration/arbitration.hpp. Test: tests/runtime/core/arbitration/arbitration_test.cpp.
// SPDX-License-Identifier: MIT
//
// Section 4.4, Grant: the first combination of choices of a unit's members in which all claims are compatible.

#include "runtime/core/arbitration/arbitration.hpp"
#include "runtime/core/base/marks.hpp"
#include "runtime/core/base/fault_injection.hpp"

namespace director {

/// Was the group, which may be claimed by `edge` for this member, held by another edge that may be equal to the member
/// or to what would be below it?
bool Pass::may_deny(Index group, Index edge, Index member) const {
  const Index holder = s_.last[group].holder;
  return holder != nil && holder != edge && holder_now(group) == nil && !is_limbo(holder) &&
         (s_.edge_marks[holder] & mark::refused) == 0 && alive(holder) &&
         !never_equal({member, Chains::current}, {holder, Chains::previous});
}

/// Can an equal stand in the way of a choice of this member, whatever is chosen?
bool Pass::may_be_denied(Index member) {
  if (!equals_) return false;
  Index found = 0;
  const auto reach = [&](Index edge) {
    const Index group = t_.edges[edge].target;
    if ((s_.group_marks[group] & mark::looked_at) == 0) s_.reach[found++] = group;
    s_.group_marks[group] |= mark::looked_at;
    return may_deny(group, edge, member);
  };
  bool yes = reach(member);
  for (Index i = 0; i < found && !yes; ++i) {
    const Range providers = t_.groups[s_.reach[i]].providers;
    for (Index p = providers.begin; p != providers.end; ++p) {
      for (const Index need : t_.list(t_.providers[p].needs)) yes = yes || reach(need);
    }
  }
  for (Index i = 0; i < found; ++i) s_.group_marks[s_.reach[i]] &= static_cast<std::uint8_t>(~mark::looked_at);
  return yes;
}

/// One member alone. Whether it is disputed is asked once for all that is tried with it.
void Pass::take_in_hand(Index member) {
  s_.member[0] = member;
  disputed_ = equals_ && (s_.traits[target(member)] & trait::flat) != 0 && !taken(member) && disputed(member);
}

/// The same where the member's target is flat: nothing is needed by what it needs.
bool Pass::disputed(Index member) const {
  const Index group = t_.edges[member].target;
  bool yes = may_deny(group, member, member);
  const Range providers = t_.groups[group].providers;
  for (Index p = providers.begin; p != providers.end && !yes; ++p) {
    for (const Index need : t_.list(t_.providers[p].needs)) yes = yes || may_deny(t_.edges[need].target, need, member);
  }
  return yes;
}

/// The first choice of the one member in hand, where its target is flat (each provider has one plan, whose groups have
/// one provider and need nothing) and no equal stands in the way: the same as next_choice with nothing to search.
bool Pass::choose_flat(bool with_conditions) {
  const Index edge = s_.member[0], group = t_.edges[edge].target;
  if (taken(edge)) return false;
  const bool as_it_is = stale_requester(edge);
  const Range providers = t_.groups[group].providers;
  s_.trial[group] = edge;
  for (Index place = 0; place < providers.size(); ++place) {
    ++work_;
    const Index provider = preferred(group, place, edge);
    if (s_.enabled[provider] == 0 && !injected(Fault::disabled_providers_run)) continue;
    if (as_it_is && provider != s_.last[group].active) continue;
    if (with_conditions && first_false(provider, edge) != nil) continue;
    if (!take_needs(provider, with_conditions)) continue;
    s_.member_provider[0] = provider;
    return true;
  }
  s_.trial[group] = nil;
  return false;
}

/// The plan of a provider of a flat group, as entries; false: it cannot be claimed, or a condition of it is false.
bool Pass::take_needs(Index provider, bool with_conditions) {
  Index end = 0;
  bool fits = true;
  for (const Index need : t_.list(t_.providers[provider].needs)) {
    const Index group = t_.edges[need].target, its_provider = t_.groups[group].providers.begin;
    fits = s_.trial[group] == nil && s_.enabled[its_provider] != 0 && !taken(need);
    if (!fits) break;
    s_.trial[group] = need;
    s_.entry_group[end] = group;
    s_.entry_need[end] = need;
    s_.entry_provider[end] = its_provider;
    s_.entry_parent[end] = nil;
    ++end;
  }
  for (Index i = 0; with_conditions && fits && i < end; ++i)
    fits = first_false(s_.entry_provider[i], s_.entry_need[i]) == nil;
  if (!fits) drop_entries(0, end);
  s_.member_entries[0] = end;
  return fits;
}

/// The first combination of choices, lexicographically over the members, in which all claims are compatible. True: it
/// is in hand (member_*, entry_*, trial) until leave_combination. Which holders stood in the way counts over all
/// choices of each member, also those that are never needed: so, where there can be any, each member's are looked at
/// once, and then combined.
bool Pass::combine(Index count, bool with_conditions) {
  for (Index i = 0; count > 1 && i < count; ++i) s_.member[i] = s_.unit[i];
  if (count == 1 && (s_.traits[target(s_.member[0])] & trait::flat) != 0 && !disputed_)
    return choose_flat(with_conditions);
  if (count == 1 && t_.groups[target(s_.member[0])].single_choice()) return next_choice(0, true, with_conditions, true);
  bool deniable = false;
  for (Index at = 0; at < count && !deniable; ++at) deniable = may_be_denied(s_.member[at]);
  if (deniable && !each_has_choice(0, count, with_conditions, true)) return false;
  Index at = 0;
  bool fresh = true, known = deniable; // that each has a choice for itself
  bool sorted = false;                 // by cluster
  for (;;) {
    if (next_choice(at, fresh, with_conditions, false)) {
      if (at + 1 == count) return true;
      ++at;
      fresh = true;
    } else if (at == 0) {
      return false;
    } else if (sorted) {
      if (t_.cluster(s_.member[at - 1]) != t_.cluster(s_.member[at])) { // no choice of another cluster helps
        leave_combination(at);
        return false;
      }
      --at;
      fresh = false;
    } else { // before all choices of those before it are tried with one that has none: a sum and no product
      leave_combination(at);
      if (!known && !each_has_choice(at, count, with_conditions, false)) return false; // those before it have one
      sort_by_cluster(count);
      sorted = true;
      at = 0;
      fresh = true;
    }
  }
}

/// What can claim the same group stands together, so that its choices are combined with each other and no others. The
/// first combination is the same: that of one cluster does not depend on another.
void Pass::sort_by_cluster(Index count) {
  for (Index i = 1; i < count; ++i) {
    const Index edge = s_.member[i], cluster = t_.cluster(edge);
    Index at = i;
    for (; at > 0 && t_.cluster(s_.member[at - 1]) > cluster; --at) s_.member[at] = s_.member[at - 1];
    s_.member[at] = edge;
  }
}

/// Of the members in order, up to the first one that has none. `record`: all choices of each, for whose sake they are
/// denied.
bool Pass::each_has_choice(Index from, Index count, bool with_conditions, bool record) {
  for (Index at = from; at < count; ++at) {
    // Alone on the stack: entries_begin() of a later member is where the earlier one ends.
    if (at > 0) s_.member_entries[at - 1] = 0;
    bool any = false;
    for (bool fresh = true; next_choice(at, fresh, with_conditions, record); fresh = false) {
      any = true;
      if (record) continue;
      drop_entries(0, s_.member_entries[at]);
      s_.trial[target(s_.member[at])] = nil;
      break;
    }
    if (!any) return false;
  }
  return true;
}

void Pass::leave_combination(Index count) {
  if (count == 0) return;
  drop_entries(0, s_.member_entries[count - 1]);
  for (Index at = 0; at < count; ++at) s_.trial[target(s_.member[at])] = nil;
}

} // namespace director
