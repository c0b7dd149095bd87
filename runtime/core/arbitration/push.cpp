// docs/semantics.md, sections 4.3 and 4.4: pushes: made, kept, in force, dropped.
// SPDX-License-Identifier: MIT
//
// For each condition that a unit waits for, the shortest chain of causing providers is searched: 1 for its last
// provider, plus the lengths for all conditions that this one lacks; a least fixed point, found by relaxing every
// provider.

#include "runtime/core/arbitration/push.hpp"

#include "runtime/core/arbitration/trail.hpp"

const char director::part::pushes = 0;

namespace director::arbitration {

namespace {

constexpr std::uint64_t endless = ~std::uint64_t{0};

bool in_unit(const Context& x, Index edge, Index count) {
  return any(members(x, count), [&](const TriedMember& member) { return member.edge == edge; });
}

bool satisfies(const Context& x, Index provider, Index condition) {
  return any(x.t.list(x.t.providers[provider].effects), [&](Index effect) { return effect == condition; });
}

bool satisfies_any(const Context& x, Index provider, Range conditions) {
  return any(x.t.list(conditions), [&](Index condition) { return satisfies(x, provider, condition); });
}

/// Keeps those pushes of a granted unit whose provider satisfies a condition of a choice, or of a push that stays.
void keep_serving_pushes(Context& x, Index count) {
  const auto is_busy = [&](Index g) { return x.s.group_marks[g].has(mark::busy); };
  const auto serves = [&](Index provider) {
    const auto helps = [&](Index chosen) {
      const Provider& row = x.t.providers[chosen];
      return satisfies_any(x, provider, row.when) || satisfies_any(x, provider, row.stay);
    };
    for (Index at = 0; at < count; ++at) {
      if (helps(x.s.member[at].provider)) return true;
      if (any(plan_of(x, at), [&](const PlanEntry& entry) { return helps(entry.provider); })) return true;
    }
    return any(pushed_groups(x), [&](Index g) {
      return is_busy(g) && satisfies_any(x, provider, x.t.providers[x.s.last[g].push.provider].aims);
    });
  };
  for (const Index g : pushed_groups(x)) x.s.group_marks[g].remove(mark::busy);
  for (bool more = true; more;) {
    more = false;
    for (const Index g : pushed_groups(x)) {
      const Push& push = x.s.last[g].push;
      if (push.edge == nil || is_busy(g) || !in_unit(x, push.edge, count) || !serves(push.provider)) continue;
      x.s.group_marks[g] |= mark::busy;
      if (x.s.now[g].push.edge == nil) x.s.now[g].push = push;
      more = true;
    }
  }
}

/// Whether this provider, with one of its plans, makes a chain shorter (or as short, and declared earlier).
bool relax(Context& x, Index provider) {
  const Provider& row = x.t.providers[provider];
  bool changed = false;
  Index end = 0, number = 0;
  x.s.trial[row.group] = 0; // no plan may use its own group
  for (bool more = search_plan(x, provider, 0, end, true, true); more;
       more = search_plan(x, provider, 0, end, false, true)) {
    const Index plan = number++;
    ++x.work;
    const std::span<const PlanEntry> entries{x.s.entry, end};
    if (any(entries, [&](const PlanEntry& entry) {
          return holder_now(x, entry.group) != nil || x.s.enabled[entry.provider] == 0;
        }))
      continue;
    std::uint64_t length = 1;
    Index lacks = nil;
    const auto add = [&](Index of) {
      if (stays(x, of)) return;
      for (const Index condition : x.t.list(x.t.providers[of].when)) {
        if (holds(x, condition)) continue;
        if (lacks == nil) lacks = condition;
        const std::uint64_t more_length = x.s.cost[condition];
        length = more_length >= endless - length ? endless : length + more_length;
      }
    };
    add(provider);
    for (const PlanEntry& entry : entries) add(entry.provider);
    if (length == endless) continue;
    for (const Index effect : x.t.list(row.effects)) {
      if (!x.s.condition_marks[effect].has(mark::lacked)) continue;
      const bool shorter = length < x.s.cost[effect];
      const Index other = x.s.cost_at[effect];
      const bool declared_first = provider < other;
      const bool earlier =
          length == x.s.cost[effect] && (declared_first || (provider == other && plan < x.s.cost_plan[effect]));
      if (!shorter && !earlier) continue;
      x.s.cost[effect] = length;
      x.s.cost_at[effect] = provider;
      x.s.cost_plan[effect] = plan;
      x.s.cost_next[effect] = lacks;
      changed = true;
    }
  }
  x.s.trial[row.group] = nil;
  return changed;
}

/// Whether a request for its group has a last chain that reaches root, goes after `member`, and is not below it.
bool can_be_pushed(const Context& x, Index provider, Index member) {
  const Index group = x.t.providers[provider].group;
  const Push there = push_so_far(x, group); // by another unit
  if (x.s.enabled[provider] == 0 || holder_now(x, group) != nil || (there.edge != nil && there.provider != provider))
    return false;
  return any(x.t.list(x.t.groups[group].requesters), [&](Index edge) {
    const Place last{edge, Chains::previous};
    return requested(x, edge) && !is_limbo(x, chain(x, last).top) && !in_chain(x, member, last) &&
           before(x, {member, Chains::current}, last);
  });
}

/// Finds the first push of the shortest chain that makes a condition of `member` true. Candidates are found backwards:
/// providers that cause it, those that cause what these lack, and so on.
bool find_chain(Context& x, Index condition, Index member, Push& out) {
  Index lacking = 0, causers = 0;
  const auto lack = [&](Index c) {
    if (x.s.condition_marks[c].has(mark::lacked)) return;
    x.s.condition_marks[c] = mark::lacked;
    x.s.cost[c] = endless;
    x.s.lacked[lacking++] = c;
  };
  lack(condition);
  for (Index i = 0; i < lacking; ++i) {
    for (const Index provider : x.t.list(x.t.conditions[x.s.lacked[i]].causers)) {
      if (x.s.provider_marks[provider].has(mark::causer) || !can_be_pushed(x, provider, member)) continue;
      x.s.provider_marks[provider] |= mark::causer;
      x.s.causers[causers++] = provider;
      for (const Index aim : x.t.list(x.t.providers[provider].aims)) {
        if (!holds(x, aim)) lack(aim);
      }
    }
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (Index i = causers; i-- != 0;) { // the ends of chains first: most lengths are final after one round
      changed = relax(x, x.s.causers[i]) || changed;
    }
  }
  const bool found = x.s.cost[condition] != endless;
  if (found) {
    while (x.s.cost_next[condition] != nil) condition = x.s.cost_next[condition];
    out = {member, x.s.cost_at[condition], condition};
  }
  for (Index i = 0; i < lacking; ++i) x.s.condition_marks[x.s.lacked[i]] = 0;
  for (Index i = 0; i < causers; ++i) x.s.provider_marks[x.s.causers[i]] = 0;
  return found;
}

} // namespace

/// The push on a group by the units so far: those before the current one.
Push push_so_far(const Context& x, Index group) {
  const Push& push = x.s.now[group].push;
  if (x.whole || push.edge == nil || push != x.s.last[group].push) return push;
  const Index from = x.t.edges[push.edge].requester;
  const bool came = x.s.edge_marks[push.edge].has(mark::visited) || (from != nil && is_passed(x, from));
  return came ? push : Push{};
}

/// As preferred(), for a group with a push.
Index preferred_by_push(const Context& x, Index group, Index place, Index edge) {
  const Index begin = x.t.groups[group].providers.begin;
  const Push push = push_so_far(x, group);
  if (!applies(x, push, edge)) return static_cast<Index>(begin + place);
  if (place == 0) return push.provider;
  const auto usual = static_cast<Index>(begin + place - 1);
  return usual < push.provider ? usual : static_cast<Index>(usual + 1);
}

/// Keeps the pushes of a unit that is granted.
void keep_own_pushes(Context& x, Index count) {
  if (!any(members(x, count), [&](const TriedMember& m) { return x.s.edge_marks[m.edge].has(mark::pushes); })) return;
  keep_serving_pushes(x, count);
  // A push that serves one member of a unit serves all; below a stale group each member has only its own.
  x.depends_on_stale = x.depends_on_stale || count > 1;
  x.depends_on_all_stale = x.depends_on_all_stale || count > 1;
}

/// Lists a group that has a push, in the last assignment or in this one.
void list_push(Context& x, Index group) {
  if (x.s.group_marks[group].has(mark::listed)) return;
  if (x.walking) open(x, group);
  x.s.group_marks[group] |= mark::listed;
  x.s.pushed[x.row.order + x.pushed_count++] = group;
}

void keep_last_pushes(Context& x, Index count) {
  for (const Index g : pushed_groups(x)) {
    const Push& push = x.s.last[g].push;
    if (push.edge != nil && x.s.now[g].push.edge == nil && in_unit(x, push.edge, count)) x.s.now[g].push = push;
  }
}

/// Whether a unit of one edge, which pushed nothing, finds no chain for the first condition that it waits for. Then it
/// still pushes nothing, whatever else it waits for.
bool finds_no_push(Context& x, Index edge) {
  if (!x.s.edge_marks[edge].has(mark::alone)) return false;
  const std::uint64_t before = x.work;
  Push push;
  if (!find_chain(x, x.s.queued[edge].condition, edge, push)) return true;
  x.work = before; // the unit is decided, and searches again
  return false;
}

/// Keeps the pushes that the unit made before, and makes new ones if every condition is served.
void push_for(Context& x, Index count, Index unmet) {
  const auto theirs = [&](Index g) { return push_so_far(x, g); };
  const Index* const pushed = x.s.pushed + x.row.order;
  const auto begin = [&](Index at) {
    const Index g = pushed[at];
    const Push& push = x.s.last[g].push;
    const bool ours = push.edge != nil && in_unit(x, push.edge, count) &&
                      (theirs(g).edge == nil || theirs(g).provider == push.provider);
    x.s.own[at] = ours ? push : Push{};
    x.s.first[at] = Push{};
    x.s.group_marks[g].remove(mark::busy);
  };
  for (Index at = 0; at < x.pushed_count; ++at) begin(at);
  bool all_served = true;
  for (Index i = 0; i < unmet; ++i) {
    bool served = false;
    for (Index at = 0; at < x.pushed_count; ++at) {
      if (x.s.own[at].edge == nil || !satisfies(x, x.s.own[at].provider, x.s.unmet[i].condition)) continue;
      x.s.group_marks[pushed[at]] |= mark::busy;
      served = true;
    }
    Push push;
    if (served) continue;
    // The search depends on the requests, claims and pushes of many groups.
    for (const TriedMember& member : members(x, count)) x.s.edge_trail[member.edge] |= trail::waits;
    if (!find_chain(x, x.s.unmet[i].condition, x.s.unmet[i].member, push)) {
      all_served = false;
      continue;
    }
    const Index group = x.t.providers[push.provider].group;
    if (!x.s.group_marks[group].has(mark::listed)) list_push(x, group), begin(static_cast<Index>(x.pushed_count - 1));
    Index at = 0;
    while (pushed[at] != group) ++at;
    if (x.s.first[at].edge == nil) x.s.first[at] = push; // one group serves one condition at a time
  }
  for (Index at = 0; at < x.pushed_count; ++at) {
    const Index g = pushed[at];
    Push &own = x.s.own[at], &first = x.s.first[at];
    const bool free = !x.s.group_marks[g].has(mark::busy) && theirs(g).edge == nil;
    if (all_served && first.edge != nil && free && own.provider != first.provider) own = first;
    if (own.edge == nil || theirs(g).edge != nil) continue;
    if (x.walking) open(x, g);
    x.s.now[g].push = own;
  }
}

/// Drops pushes whose unit is not decided any more, or on groups that are not requested any more, and determines which
/// of the others are in force.
void finish_pushes(Context& x) {
  const auto is_requested = [&](Index edge) { // by root or a live group
    const Index from = x.t.edges[edge].requester;
    return requested(x, edge) && (from == nil || x.s.now[from].active != nil);
  };
  constexpr Index bits = flag::in_force | flag::serving;
  for (const Index g : pushed_groups(x)) {
    GroupAssignment& now = x.s.now[g];
    Push push = push_so_far(x, g);
    Index flags = 0;
    if (push.edge != nil && now.holder == nil && !any(x.t.list(x.t.groups[g].requesters), is_requested)) {
      x.s.edge_trail[push.edge] |= trail::on_stale; // the unit that may make it again has to be decided again
      const Index from = x.t.edges[push.edge].requester;
      if (from != nil) open_as_it_is(x, from);
      x.depends_on_last = true;
      push = Push{};
    }
    if (push.edge != nil && now.holder != nil) {
      const bool in_force =
          is_opened(x, g)
              ? now.active == push.provider && (now.granted() || x.s.last[g].in_force()) && applies(x, push, now.holder)
              : now.in_force(); // the same rule for the same assignment
      if (in_force) flags = holds(x, push.condition) ? flag::in_force : bits;
    }
    x.depends_on_last = x.depends_on_last || push.edge != nil;
    if (push == now.push && flags == (now.flags & bits)) continue;
    open_as_it_is(x, g);
    now.push = push;
    now.flags = static_cast<Index>((now.flags & ~bits) | flags);
  }
}

/// Marks the groups with a push in the last assignment, and the edges that made it.
void mark_pushers(Context& x) {
  for (const Index g : pushed_groups(x)) {
    x.s.group_marks[g] |= mark::listed;
    if (x.s.last[g].push.edge != nil) x.s.edge_marks[x.s.last[g].push.edge] |= mark::pushes;
  }
}

/// Withdraws the pushes that the edge made before, and that no other unit has replaced. Its decision keeps what stays.
void withdraw_pushes(Context& x, Index edge) {
  for (const Index g : pushed_groups(x)) {
    if (x.s.last[g].push.edge != edge || x.s.now[g].push != x.s.last[g].push) continue;
    open(x, g);
    open_as_it_is(x, g); // if it was passed by
    x.s.now[g].push = Push{};
  }
}

void reach_pushes(Context& x, Index edge) {
  for (const Index g : pushed_groups(x)) {
    if (x.s.last[g].push.edge == edge) reach(x, g);
  }
}

} // namespace director::arbitration
