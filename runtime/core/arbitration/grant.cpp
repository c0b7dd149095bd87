// docs/semantics.md, section 4.4, Grant: a unit gets its targets, and all that their plans need.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/grant.hpp"

#include "runtime/core/arbitration/availability.hpp"
#include "runtime/core/arbitration/choices.hpp"
#include "runtime/core/arbitration/order.hpp"
#include "runtime/core/arbitration/push.hpp"
#include "runtime/core/arbitration/staleness.hpp"

namespace director::arbitration {

namespace {

enum class Tried : std::uint8_t { granted, refused, unclear };

void grant_plain(Context& x, Index edge, Index provider) {
  claim(x, x.t.edges[edge].target, edge);
  now_granted(x, edge, provider);
  for (const Index need : x.t.list(x.t.providers[provider].needs)) {
    const Index group = x.t.edges[need].target;
    claim(x, group, need);
    x.s.now[group].flags |= flag::needed;
    if (!x.s.now[group].granted()) x.s.now[group].planned = x.t.groups[group].providers.begin;
  }
}

void repeat_grant(Context& x, Index edge) {
  const Index group = target(x, edge), provider = x.s.last[group].active;
  if (!x.t.groups[group].flat) {
    const Index end = entries_of(x, group, x.s.last);
    claim(x, group, edge);
    now_granted(x, edge, provider);
    plan_for(x, group, provider, 0, end);
    for (Index i = 0; i < end; ++i) claim(x, x.s.entry_group[i], x.s.entry_need[i]);
    claim_plan(x, 0, end);
  } else if (!x.t.groups[group].simple) {
    grant_plain(x, edge, provider);
  } else {
    claim(x, group, edge);
    now_granted(x, edge, provider);
  }
}

/// What a provider of the flat target of `edge` needs: nobody has claimed it, and it can run.
bool needs_are_free(const Context& x, Index edge, Range needs) {
  const auto is_free = [&](Index need) {
    const Index group = x.t.edges[need].target, provider = x.t.groups[group].providers.begin;
    return !taken(x, need) && x.s.enabled[provider] != 0 &&
           (!x.t.groups[group].conditional || first_false(x, provider, need) == nil);
  };
  bool all = true;
  Index& above = x.s.trial[x.t.edges[edge].target]; // the chains of what it needs go through it
  above = edge;
  for (const Index need : x.t.list(needs)) all = all && is_free(need);
  above = nil;
  return all;
}

/// The same as try_members where what is needed is simple and nothing can stand in the way but what is claimed already.
[[gnu::always_inline]] inline Tried try_plain(Context& x, Index edge, bool outdated) {
  const Index group = x.t.edges[edge].target;
  const GroupAssignment& last = x.s.last[group];
  const bool as_before = last.holder == edge && last.granted();
  const Group& row = x.t.groups[group];
  if (!row.flat || taken(x, edge)) return Tried::unclear;
  if (!as_before && (outdated || x.stale_granted != 0)) return Tried::unclear;
  if (x.disputed) return Tried::unclear;
  const Range providers = row.providers;
  for (Index place = 0; place != providers.size(); ++place) {
    const Index p = x.s.now[group].push.edge == nil ? static_cast<Index>(providers.begin + place)
                                                    : preferred(x, group, place, edge);
    if (x.s.enabled[p] == 0 || (outdated && p != last.active)) continue;
    if (row.conditional && first_false(x, p, edge) != nil) continue;
    if (!row.simple) {
      if (!needs_are_free(x, edge, x.t.providers[p].needs)) continue;
      grant_plain(x, edge, p);
    } else {
      claim(x, group, edge);
      now_granted(x, edge, p);
    }
    if ((x.s.edge_marks[edge] & mark::pushes) != 0) keep_pushes_of_plain(x, edge, p);
    return Tried::granted;
  }
  return injected(Fault::disabled_providers_run) ? Tried::unclear : Tried::refused;
}

} // namespace

void try_members(Context& x, Index count, bool outdated) {
  if (outdated && any_new(x, count) && !injected(Fault::outdated_orders_acquire)) {
    for (Index at = 0; at < count; ++at) x.s.edge_marks[x.s.member[at]] |= mark::refused;
    keep_pushes(x, count); // it is not even tried
    return explain(x, count, Why::outdated);
  }
  if (count == 1 && taken(x, x.s.member[0])) return block(x, 1);
  if (!combine(x, count, true)) return refuse(x, count);
  if (!premature(x, count)) return grant(x, count);
  x.depends_on_stale = true;
  leave_combination(x, count);
  defer(x, count); // of a stale requester nothing gets here: the members in hand are those of the unit
}

void grant(Context& x, Index count) {
  for (Index at = 0; at < count; ++at) {
    const Index edge = x.s.member[at], group = x.t.edges[edge].target, begin = entries_begin(x, at),
                end = x.s.member_entries[at];
    claim(x, group, edge);
    now_granted(x, edge, x.s.member_provider[at]);
    plan_for(x, group, x.s.member_provider[at], begin, end);
    for (Index i = begin; i < end; ++i) claim(x, x.s.entry_group[i], x.s.entry_need[i]);
    claim_plan(x, begin, end);
  }
  if (x.had_pushes) keep_own_pushes(x, count);
  leave_combination(x, count);
}

/// A unit of this one edge stands as it stood.
void repeat(Context& x, Index edge) {
  x.s.edge_marks[edge] |= mark::visited;
  if (runs_for_now(x, edge)) {
    repeat_grant(x, edge);
  } else {
    x.s.edge_marks[edge] |= mark::refused;
  }
  if ((x.s.edge_marks[edge] & mark::pushes) == 0) return;
  x.s.member[0] = edge;
  keep_pushes(x, 1);
}

void decide_alone(Context& x, Index edge, bool outdated) {
  take_in_hand(x, edge);
  switch (try_plain(x, edge, outdated)) {
  case Tried::granted: return;
  case Tried::refused: return refuse(x, 1);
  case Tried::unclear: return try_members(x, 1, outdated);
  }
}

} // namespace director::arbitration
