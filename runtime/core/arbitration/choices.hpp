#pragma once
// SPDX-License-Identifier: MIT
// A choice is a way to grant a group to an edge: a provider, and a plan for its needs, all of whose groups are
// available. The current combination has one for each member of a unit. It is in State::member, State::entry (the
// plans, one behind the other) and State::trial (what it would claim) until leave_combination. docs/semantics.md,
// sections 4.2, 4.3 and 4.4, Grant.

#include "runtime/core/arbitration/order.hpp"

namespace director::arbitration {

// Of groups with equal claimants: availability.cpp.
DIRECTOR_PART bool kept_by_equal(Context& x, Index group, Index edge, bool record);
DIRECTOR_PART bool denied_in_vain(Context& x);

/// Whether the edge may claim the group. `record`: a denial counts.
DIRECTOR_ONE_COPY inline bool available(Context& x, Index group, Index edge, bool record) {
  const Index claimant = holder_now(x, group);
  if (claimant != nil) return claimant == edge;
  const Index before = x.s.last[group].holder;
  return before == nil || before == edge || is_limbo(x, before) || !x.t.groups[group].equals ||
         !kept_by_equal(x, group, edge, record);
}

inline void drop_entries(Context& x, Index begin, Index end) {
  for (Index i = end; i-- > begin;) x.s.trial[x.s.entry[i].group] = nil;
}

/// The slot of the plan of `owner` that has the provider picked for `group`; nil if the group has only one.
inline Index slot_of(const Context& x, Index owner, Index group) {
  for (const Index slot : x.t.groups[owner].slots.rows()) {
    if (x.t.plan_groups[slot] == group) return slot;
  }
  return nil;
}

inline std::span<TriedMember> members(const Context& x, Index count) { return {x.s.member, count}; }

/// The first entry of a member's plan.
inline Index entries_begin(const Context& x, Index at) { return at == 0 ? Index{0} : x.s.member[at - 1].entries_end; }

DIRECTOR_ONE_COPY inline std::span<const PlanEntry> plan_of(const Context& x, Index at) {
  return {x.s.entry + entries_begin(x, at), x.s.entry + x.s.member[at].entries_end};
}

// Conditions: refuse.cpp.
bool stays(const Context& x, Index provider);
DIRECTOR_PART Index find_false(const Context& x, Index provider, Index edge);

/// The first condition that prevents the provider from running for an edge, or nil.
inline Index first_false(const Context& x, Index provider, Index edge) {
  return x.t.providers[provider].when.empty() ? nil : find_false(x, provider, edge);
}

// Plans: searched as entries, claimed, and read again as entries. plans.cpp.
DIRECTOR_PART bool search_plan(Context& x, Index provider, Index begin, Index& end, bool fresh, bool by_declaration);
DIRECTOR_PART bool find_plan(Context& x, Index at, bool first, bool as_it_is, bool with_conditions, bool record);
DIRECTOR_PART bool needs_claimed(const Context& x, Index group);
DIRECTOR_PART void claim_plan(Context& x, Index owner, Index provider, Index begin, Index end);
DIRECTOR_PART Index entries_of(Context& x, Index group, const Assignment& of);

bool combine(Context& x, Index count, bool with_conditions);
bool next_choice(Context& x, Index at, bool fresh, bool with_conditions, bool record);
DIRECTOR_PART bool search_combination(Context& x, Index count, bool with_conditions); // combination.cpp
void leave_combination(Context& x, Index count);

} // namespace director::arbitration
