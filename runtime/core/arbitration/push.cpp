// Door: runtime/core/arbitration/arbitration.hpp. Test: tests/runtime/core/arbitration/arbitration_test.cpp.
// SPDX-License-Identifier: MIT
//
// Section 4.4, Refuse: the pushes of a unit that waits for conditions. For each condition the shortest chain of causing
// providers is searched: the length of a chain is 1 for its last provider plus the lengths for all that this one lacks,
// a least fixed point over conditions, found by relaxing every causing provider until nothing gets shorter.

#include "runtime/core/arbitration/arbitration.hpp"
#include "runtime/core/base/marks.hpp"
#include "runtime/core/base/fault_injection.hpp"

namespace director {

namespace {
constexpr std::uint64_t endless = ~std::uint64_t{0};
} // namespace

bool Pass::in_unit(Index edge, Index count) const {
  for (Index at = 0; at < count; ++at) {
    if (s_.member[at] == edge) return true;
  }
  return false;
}

/// The false conditions of the combination in hand, member by member: its provider's, then its plan's.
Index Pass::collect_unmet(Index count) {
  Index found = 0;
  for (Index place = 0; place < count; ++place) { // in order of the unit, also where the search had another one
    Index at = place;
    for (Index other = 0; count > 1 && s_.member[at] != s_.unit[place]; ++other) at = other;
    const auto add = [&](Index provider, Index edge) {
      if (stays(provider)) return;
      for (const Index condition : t_.list(t_.providers[provider].when)) {
        if (holds(condition) || waived(provider, condition, edge)) continue;
        s_.unmet_member[found] = s_.member[at];
        s_.unmet[found++] = condition;
      }
    };
    add(s_.member_provider[at], s_.member[at]);
    for (Index i = entries_begin(at); i < s_.member_entries[at]; ++i) add(s_.entry_provider[i], s_.entry_need[i]);
  }
  return found;
}

bool Pass::satisfies(Index provider, Index condition) const {
  for (const Index effect : t_.list(t_.providers[provider].effects)) {
    if (effect == condition) return true;
  }
  return false;
}

bool Pass::somebody_satisfies(Index condition) const {
  for (const Index provider : t_.list(t_.conditions[condition].causers)) {
    if (s_.enabled[provider] != 0) return true;
  }
  return false;
}

/// The group has a push, in the last assignment or in this one.
void Pass::list_push(Index group) {
  if ((s_.group_marks[group] & mark::listed) != 0) return;
  if (walking_) open(group);
  s_.group_marks[group] |= mark::listed;
  s_.pushed[c_.order + pushed_count_++] = group;
}

void Pass::set_push(Index group, const Push& push) {
  list_push(group);
  s_.now[group].push = push;
  pushing_ = true;
}

/// The pushes that the unit made before stay.
void Pass::keep_pushes(Index count) {
  if (!pushes(count)) return;
  for (const Index g : pushed_groups()) {
    const Push& push = s_.last[g].push;
    if (push.edge != nil && s_.now[g].push.edge == nil && in_unit(push.edge, count)) set_push(g, push);
  }
}

/// Conditions that are wanted are marked; unmarked with another mark of 0.
void Pass::want(Range conditions, std::uint8_t bits) {
  for (const Index condition : t_.list(conditions)) s_.condition_marks[condition] = bits;
}

/// The unit is granted: of its pushes those stay that serve the choices in hand, or a push that does.
void Pass::keep_serving_pushes(Index count) {
  const auto want_provider = [&](Index provider, std::uint8_t bits) {
    want(t_.providers[provider].when, bits);
    want(t_.providers[provider].stay, bits);
  };
  const auto want_all = [&](std::uint8_t bits) {
    for (Index at = 0; at < count; ++at) {
      want_provider(s_.member_provider[at], bits);
      for (Index i = entries_begin(at); i < s_.member_entries[at]; ++i) want_provider(s_.entry_provider[i], bits);
    }
  };
  const auto serves = [&](Index provider) {
    for (const Index effect : t_.list(t_.providers[provider].effects)) {
      if (s_.condition_marks[effect] != 0) return true;
    }
    return false;
  };
  want_all(mark::wanted);
  for (const Index g : pushed_groups()) s_.group_marks[g] &= static_cast<std::uint8_t>(~mark::busy);
  for (bool more = true; more;) {
    more = false;
    for (const Index g : pushed_groups()) {
      const Push& push = s_.last[g].push;
      if (push.edge == nil || (s_.group_marks[g] & mark::busy) != 0 || !in_unit(push.edge, count) ||
          !serves(push.provider))
        continue;
      s_.group_marks[g] |= mark::busy;
      want(t_.providers[push.provider].aims, mark::wanted);
      if (s_.now[g].push.edge == nil) set_push(g, push);
      more = true;
    }
  }
  want_all(0);
  for (const Index g : pushed_groups()) {
    if ((s_.group_marks[g] & mark::busy) != 0) want(t_.providers[s_.last[g].push.provider].aims, 0);
  }
}

/// Pushes made before stay; new ones are made only if every condition is served.
void Pass::push_for(Index count, Index unmet) {
  const auto theirs = [&](Index g) -> const Push& { return s_.now[g].push; }; // made by units before this one
  const auto begin = [&](Index g) {
    const Push& push = s_.last[g].push;
    const bool ours =
        push.edge != nil && in_unit(push.edge, count) && (theirs(g).edge == nil || theirs(g).provider == push.provider);
    s_.own[g] = ours ? push : Push{};
    s_.first[g] = Push{};
    s_.group_marks[g] &= static_cast<std::uint8_t>(~mark::busy);
  };
  // It looks at the requests, claims and pushes of many.
  for (Index at = 0; at < count; ++at) s_.edge_trail[s_.member[at]] |= trail::waits;
  for (const Index g : pushed_groups()) begin(g);
  bool all_served = true;
  for (Index i = 0; i < unmet; ++i) {
    bool served = false;
    for (const Index g : pushed_groups()) {
      if (s_.own[g].edge == nil || !satisfies(s_.own[g].provider, s_.unmet[i])) continue;
      s_.group_marks[g] |= mark::busy;
      served = true;
    }
    Push push;
    if (served) continue;
    if (!find_chain(s_.unmet[i], s_.unmet_member[i], push)) {
      all_served = false;
      continue;
    }
    const Index group = t_.providers[push.provider].group;
    if ((s_.group_marks[group] & mark::listed) == 0) list_push(group), begin(group);
    Push& first = s_.first[group];
    if (first.edge == nil) first = push; // one group serves one condition after the other
  }
  for (const Index g : pushed_groups()) {
    const bool free = (s_.group_marks[g] & mark::busy) == 0 && theirs(g).edge == nil;
    if (all_served && s_.first[g].edge != nil && free && s_.own[g].provider != s_.first[g].provider)
      s_.own[g] = s_.first[g];
    if (s_.own[g].edge != nil && theirs(g).edge == nil) set_push(g, s_.own[g]);
  }
}

/// The first push of the shortest chain that makes a condition of `member` true. What can lead to it is found
/// backwards: who causes it, what these lack, who causes that, and so on.
bool Pass::find_chain(Index condition, Index member, Push& out) {
  Index lacking = 0, causers = 0;
  const auto lack = [&](Index c) {
    if ((s_.condition_marks[c] & mark::lacked) != 0) return;
    s_.condition_marks[c] = mark::lacked;
    s_.cost[c] = endless;
    s_.lacked[lacking++] = c;
  };
  lack(condition);
  for (Index i = 0; i < lacking; ++i) {
    for (const Index provider : t_.list(t_.conditions[s_.lacked[i]].causers)) {
      if ((s_.provider_marks[provider] & mark::looked_at) != 0) continue;
      s_.provider_marks[provider] |= mark::looked_at;
      s_.causers[causers++] = provider;
      if (!can_be_pushed(provider, member)) continue;
      s_.provider_marks[provider] |= mark::pushable;
      for (const Index aim : t_.list(t_.providers[provider].aims)) {
        if (!holds(aim)) lack(aim);
      }
    }
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (Index i = 0; i < causers; ++i) {
      if ((s_.provider_marks[s_.causers[i]] & mark::pushable) != 0) changed = relax(s_.causers[i]) || changed;
    }
  }
  const bool found = s_.cost[condition] != endless;
  if (found) {
    while (s_.cost_next[condition] != nil) condition = s_.cost_next[condition];
    out = {member, s_.cost_at[condition], condition};
  }
  for (Index i = 0; i < lacking; ++i) s_.condition_marks[s_.lacked[i]] = 0;
  for (Index i = 0; i < causers; ++i) s_.provider_marks[s_.causers[i]] = 0;
  return found;
}

/// Does this provider, with one of its plans, make a chain shorter (or as short, and declared earlier)?
bool Pass::relax(Index provider) {
  const Provider& row = t_.providers[provider];
  bool changed = false;
  Index end = 0, number = 0;
  s_.trial[row.group] = 0; // its own group counts as used
  for (bool more = search_plan(provider, 0, end, true, true); more; more = search_plan(provider, 0, end, false, true)) {
    const Index plan = number++;
    ++work_;
    bool possible = true;
    for (Index i = 0; i < end; ++i)
      possible = possible && holder_now(s_.entry_group[i]) == nil && s_.enabled[s_.entry_provider[i]] != 0;
    if (!possible) continue;
    std::uint64_t length = 1;
    Index lacks = nil;
    const auto add = [&](Index of) {
      if (stays(of)) return;
      for (const Index condition : t_.list(t_.providers[of].when)) {
        if (holds(condition)) continue;
        if (lacks == nil) lacks = condition;
        const std::uint64_t more_length = s_.cost[condition];
        length = more_length >= endless - length ? endless : length + more_length;
      }
    };
    add(provider);
    for (Index i = 0; i < end; ++i) add(s_.entry_provider[i]);
    if (length == endless) continue;
    for (const Index effect : t_.list(row.effects)) {
      if ((s_.condition_marks[effect] & mark::lacked) == 0) continue;
      const bool shorter = length < s_.cost[effect];
      const Index other = s_.cost_at[effect];
      const bool declared_first = injected(Fault::the_later_provider_is_pushed) ? provider > other : provider < other;
      const bool earlier =
          length == s_.cost[effect] && (declared_first || (provider == other && plan < s_.cost_plan[effect]));
      if (!shorter && !earlier) continue;
      s_.cost[effect] = length;
      s_.cost_at[effect] = provider;
      s_.cost_plan[effect] = plan;
      s_.cost_next[effect] = lacks;
      changed = true;
    }
  }
  s_.trial[row.group] = nil;
  return changed;
}

bool Pass::can_be_pushed(Index provider, Index member) const {
  const Index group = t_.providers[provider].group;
  const Push& there = s_.now[group].push; // by another unit
  if (s_.enabled[provider] == 0 || holder_now(group) != nil || (there.edge != nil && there.provider != provider))
    return false;
  for (const Index edge : t_.list(t_.groups[group].requesters)) {
    if (requested(edge) && goes_before(member, edge)) return true;
  }
  return false;
}

/// The edge's last chain reaches root, `member` goes before it, and it is not below `member`.
bool Pass::goes_before(Index member, Index edge) const {
  const Index top = chain({edge, Chains::previous}).top;
  return top != nil && !is_limbo(top) && !in_chain(member, {edge, Chains::previous}) &&
         compare({member, Chains::current}, {edge, Chains::previous}, false) < 0;
}

} // namespace director
