// Door: runtime/core/arbitration/arbitration.hpp. Test: tests/runtime/core/arbitration/arbitration_test.cpp.
// SPDX-License-Identifier: MIT
//
// Section 4.4: what becomes of a unit: granted, deferred or refused.
#include "runtime/core/arbitration/arbitration.hpp"
#include "runtime/core/base/marks.hpp"
#include "runtime/core/base/fault_injection.hpp"

namespace director {

void Pass::try_members(Index count, bool outdated) {
  if (outdated && any_new(count) && !injected(Fault::outdated_orders_acquire)) {
    for (Index at = 0; at < count; ++at) s_.edge_marks[s_.member[at]] |= mark::refused;
    keep_pushes(count); // it is not even tried
    return explain(count, Why::outdated);
  }
  if (count == 1 && taken(s_.member[0])) return block(1);
  if (!combine(count, true)) return refuse(count);
  if (!premature(count)) return grant(count);
  depends_on_stale_ = true;
  leave_combination(count);
  defer(count); // of a stale requester nothing gets here: the members in hand are those of the unit
}

/// The same as all that follows, where several members have nothing to choose: each target has one provider, which
/// needs nothing, and all goes well. False: it does not, and nothing was claimed.
bool Pass::try_simple(Index count) {
  for (Index at = 0; at < count; ++at) {
    const Index edge = s_.member[at], group = t_.edges[edge].target;
    if ((s_.traits[group] & trait::simple) == 0) return false;
    if (!runs_for_now(edge)) {
      if (stale_granted_ != 0 || !available(group, edge, true)) return false;
    } else if (taken(edge)) {
      return false;
    }
    const Index provider = t_.groups[group].providers.begin;
    if (s_.enabled[provider] == 0) return false;
    if ((s_.traits[group] & trait::conditional) != 0 && first_false(provider, edge) != nil) return false;
    s_.member_provider[at] = provider;
    s_.member_entries[at] = 0;
  }
  for (Index at = 0; at < count; ++at) {
    claim(t_.edges[s_.member[at]].target, s_.member[at]);
    now_granted(s_.member[at], s_.member_provider[at]);
  }
  if (pushed_) keep_own_pushes(count);
  return true;
}

/// What was granted before stays, the others wait for the runs to come.
void Pass::defer(Index count) {
  for (Index i = 0; i < count; ++i) {
    take_in_hand(s_.unit[i]);
    if (runs_for_now(s_.member[0]) && combine(1, true)) {
      grant(1);
    } else {
      s_.edge_marks[s_.member[0]] |= mark::refused;
      keep_pushes(1);
      explain(1, Why::deferred);
    }
  }
}

/// For a member that is new, the combination in hand claims what a stale group that goes before it may still ask for.
bool Pass::premature(Index count) {
  if (stale_granted_ == 0 || injected(Fault::nothing_is_deferred)) return false;
  for (Index at = 0; at < count; ++at) {
    const Index edge = s_.member[at];
    if (runs_for_now(edge)) continue;
    Index found = 0;
    s_.reach[found++] = target(edge);
    for (Index i = entries_begin(at); i < s_.member_entries[at]; ++i) s_.reach[found++] = s_.entry_group[i];
    if (reached_from_stale(found, edge)) return true;
  }
  return false;
}

/// Upwards from the groups in `reach`: may a granted stale group ask for one of them, transitively? With an edge: only
/// one that goes before it and is not above it.
bool Pass::reached_from_stale(Index found, Index edge) {
  const auto counts = [&](Index group) {
    if ((s_.now[group].flags & flag::granted) == 0 || !is_outdated(group) || holder_now(group) == nil) return false;
    const Index holder = s_.now[group].holder;
    return edge == nil || (!in_chain(holder, {edge, Chains::current}) && before({holder, Chains::current}, {edge, Chains::current}));
  };
  const Index claims = found;
  bool yes = false;
  for (Index i = 0; i < found && !yes; ++i) {
    for (const Index up : t_.list(t_.groups[s_.reach[i]].requesters)) {
      const Index group = t_.edges[up].requester;
      if (group == nil || (s_.group_marks[group] & mark::reached) != 0) continue;
      s_.group_marks[group] |= mark::reached;
      yes = yes || counts(group);
      bool listed = false;
      for (Index j = 0; j < claims; ++j) listed = listed || s_.reach[j] == group;
      if (!listed) s_.reach[found++] = group;
    }
  }
  for (Index i = 0; i < found; ++i) s_.group_marks[s_.reach[i]] &= static_cast<std::uint8_t>(~mark::reached);
  return yes;
}

void Pass::grant(Index count) {
  for (Index at = 0; at < count; ++at) {
    const Index edge = s_.member[at], group = t_.edges[edge].target, begin = entries_begin(at),
                end = s_.member_entries[at];
    claim(group, edge);
    now_granted(edge, s_.member_provider[at]);
    plan_for(group, s_.member_provider[at], begin, end);
    for (Index i = begin; i < end; ++i) claim(s_.entry_group[i], s_.entry_need[i]);
    claim_plan(begin, end);
  }
  if (pushed_) keep_own_pushes(count);
  leave_combination(count);
}

/// A member in hand has made a push before.
bool Pass::pushes(Index count) const {
  for (Index at = 0; at < count; ++at) {
    if ((s_.edge_marks[s_.member[at]] & mark::pushes) != 0) return true;
  }
  return false;
}

void Pass::keep_own_pushes(Index count) {
  if (!pushes(count)) return;
  if (!injected(Fault::served_pushes_end)) keep_serving_pushes(count);
  // What serves one member of a unit serves all; below a stale group each member has only its own.
  depends_on_stale_ = depends_on_stale_ || count > 1;
}

/// The plan of `owner` for its provider is entries [begin, end).
void Pass::plan_for(Index owner, Index provider, Index begin, Index end) {
  const Range slots = t_.groups[owner].slots;
  s_.now[owner].planned = provider;
  for (Index slot = slots.begin; slot != slots.end; ++slot) s_.now.plan[slot] = nil;
  if (slots.empty()) return;
  for (Index i = begin; i < end; ++i) {
    const Index slot = slot_of(owner, s_.entry_group[i]);
    if (slot != nil) s_.now.plan[slot] = s_.entry_provider[i];
  }
}

/// Every group of a plan is needed from now on; one that is not granted has the part of the plan that it needs.
void Pass::claim_plan(Index begin, Index end) {
  for (Index i = begin; i < end; ++i) {
    const Index group = s_.entry_group[i];
    s_.now[group].flags |= flag::needed;
    if ((s_.now[group].flags & flag::granted) != 0) continue;
    auto below = static_cast<Index>(i + 1); // depth first: what an entry needs stands right behind it
    while (below < end && s_.entry_parent[below] != nil && s_.entry_parent[below] >= i) ++below;
    plan_for(group, s_.entry_provider[i], static_cast<Index>(i + 1), below);
  }
}

/// Whatever is chosen, something of it is not available.
void Pass::block(Index count) {
  for (Index at = 0; at < count; ++at) s_.edge_marks[s_.member[at]] |= mark::refused;
  if (injected(Fault::blocked_units_push_on)) keep_pushes(count);
  explain(count, Why::blocked);
}

/// An edge before it has its target, and what it had before is nothing: nothing else counts, and nothing differs.
void Pass::block_alone(Index edge) {
  s_.edge_marks[edge] |= mark::visited | mark::refused;
  s_.queued[edge] = {Why::blocked, nil};
  if (is_followed()) rest_on(edge, 0);
}

/// No combination is available with its conditions true.
void Pass::refuse(Index count) {
  for (Index at = 0; at < count; ++at) s_.edge_marks[s_.member[at]] |= mark::refused;
  if (!combine(count, false)) return block(count);
  depends_on_last_ = true;
  const Index unmet = collect_unmet(count);
  const bool early = stale_requester(s_.member[0]) || premature(count);
  depends_on_stale_ = depends_on_stale_ || early;
  leave_combination(count);
  explain(count, Why::waiting, s_.unmet[0]);
  if (early) return keep_pushes(count);
  for (Index i = 0; i < unmet; ++i) {
    if (somebody_satisfies(s_.unmet[i]) || injected(Fault::pushes_though_the_outside_decides)) continue;
    return; // it waits for the outside, and holds nobody back
  }
  push_for(count, unmet);
}

void Pass::explain(Index count, Why why, Index condition) {
  for (Index at = 0; at < count; ++at) s_.queued[s_.member[at]] = {why, condition};
}

} // namespace director
