// Door: runtime/core/arbitration.hpp. Test: tests/runtime/core/arbitration_test.cpp.
//
// Section 4.4: the pass. Candidates are tried in order, unit by unit; what is granted adds the edges of its pack.

#include "runtime/core/arbitration.hpp"
#include "runtime/core/marks.hpp"
#include "runtime/core/planted.hpp"

namespace director {

void Pass::arbitrate() {
  for (const Index g : t_.list(c_.groups)) s_.group_marks[g] = 0;
  do {
    clear();
    sweep();
  } while (denied_in_vain());
  hand_over();
  finish();
}

void Pass::clear() {
  candidates_ = denied_ = stale_granted_ = 0;
  for (const Index g : t_.list(c_.groups)) {
    s_.now[g] = Standing{};
    s_.group_marks[g] &= mark::forgotten;
    const Range slots = t_.groups[g].slots;
    for (Index slot = slots.begin; slot != slots.end; ++slot) s_.now.plan[slot] = nil;
    pushed_ = pushed_ || s_.last[g].push.edge != nil;
  }
  depends_on_last_ = depends_on_last_ || pushed_;
  for (const Index e : t_.list(c_.edges)) {
    s_.edge_marks[e] = 0;
    s_.next_queued[e] = Queued{};
  }
  for (const Index e : t_.list(c_.edges)) {
    if (t_.edges[e].requester != nil) break; // edges of root come first
    become_candidate(e);
  }
}

/// 4.2: the first holder for whose sake a group was denied that does not claim it in the end is forgotten.
bool Pass::denied_in_vain() {
  for (Index i = 0; i < denied_; ++i) {
    const Index group = s_.denied[i];
    if (s_.now[group].holder == s_.last[group].holder || planted(Fault::denials_are_final)) continue;
    s_.group_marks[group] |= mark::forgotten;
    return true;
  }
  return false;
}

void Pass::become_candidate(Index edge) {
  if (!requested(edge) || (s_.edge_marks[edge] & (mark::candidate | mark::tried)) != 0) return;
  s_.edge_marks[edge] |= mark::candidate;
  Index at = candidates_++;
  while (at > 0) {
    const auto parent = static_cast<Index>((at - 1) / 2);
    if (compare({edge, Along::now}, {s_.candidate[parent], Along::now}, true) > 0) break;
    s_.candidate[at] = s_.candidate[parent];
    at = parent;
  }
  s_.candidate[at] = edge;
}

void Pass::become_candidates(Index group) {
  const Range edges = t_.groups[group].edges;
  for (Index e = edges.begin; e != edges.end; ++e) become_candidate(e);
}

/// Takes the first in order off the heap.
Index Pass::first_candidate() {
  const Index first = s_.candidate[0], moved = s_.candidate[--candidates_];
  Index at = 0;
  for (;;) {
    auto child = static_cast<Index>(2 * at + 1);
    if (child >= candidates_) break;
    const auto other = static_cast<Index>(child + 1);
    if (other < candidates_ && compare({s_.candidate[other], Along::now}, {s_.candidate[child], Along::now}, true) < 0)
      child = other;
    if (compare({moved, Along::now}, {s_.candidate[child], Along::now}, true) < 0) break;
    s_.candidate[at] = s_.candidate[child];
    at = child;
  }
  if (candidates_ != 0) s_.candidate[at] = moved;
  return first;
}

/// Of what is held for a need only, the pack counts while it waits for its orders, and no longer.
bool Pass::may_ask(Index group) const {
  return group == nil || (s_.now[group].flags & flag::granted) != 0 || stale(group);
}

bool Pass::alone(Index edge) const {
  const Level& level = t_.levels[s_.request[edge]];
  return requester(edge) == nil || level.optional || level.apart || planted(Fault::members_for_themselves);
}

/// Tries candidates, the first in order first, until none is left.
void Pass::sweep() {
  while (candidates_ != 0) {
    const Index first = first_candidate();
    if ((s_.edge_marks[first] & mark::candidate) == 0) continue; // it was tried as a member of a unit
    if (!may_ask(requester(first))) {
      s_.edge_marks[first] &= static_cast<std::uint8_t>(~mark::candidate);
      continue;
    }
    Index count = 0;
    const auto join = [&](Index edge) {
      s_.edge_marks[edge] = static_cast<std::uint8_t>((s_.edge_marks[edge] & ~mark::candidate) | mark::tried);
      Index at = count++; // members in order
      for (; at > 0 && compare({edge, Along::now}, {s_.unit[at - 1], Along::now}, true) < 0; --at)
        s_.unit[at] = s_.unit[at - 1];
      s_.unit[at] = edge;
    };
    join(first);
    if (!alone(first)) {
      const Range siblings = t_.groups[requester(first)].edges;
      for (Index e = siblings.begin; e != siblings.end; ++e) {
        if ((s_.edge_marks[e] & mark::candidate) != 0 && !alone(e)) join(e);
      }
    }
    try_unit(count);
  }
}

/// A group whose orders are outdated.
bool Pass::stale(Index group) const {
  for (;;) {
    const Index edge = s_.now[group].holder;
    if (is_limbo(edge)) return true;
    if ((s_.now[group].flags & flag::granted) != 0) {
      constexpr auto outdating = static_cast<std::uint8_t>(static_cast<std::uint8_t>(Reason::new_task) |
                                                           static_cast<std::uint8_t>(Reason::pushed));
      return (s_.pending[group] & outdating) != 0 || s_.anew[edge] != 0 || edge != s_.last[group].holder ||
             s_.now[group].active != s_.last[group].active;
    }
    group = requester(edge); // held only as a need: while its requester is stale
    if (group == nil) return false;
  }
}

bool Pass::stale_requester(Index edge) const {
  const Index group = requester(edge);
  return group != nil && stale(group);
}

/// Its target was granted to it before this pass.
bool Pass::runs_for_now(Index edge) const {
  const Index group = target(edge);
  return s_.last[group].holder == edge && (s_.last[group].flags & flag::granted) != 0;
}

/// Something new on behalf of outdated orders.
bool Pass::outdated_order(Index count) const {
  if (!stale_requester(s_.member[0]) || planted(Fault::outdated_orders_acquire)) return false;
  for (Index at = 0; at < count; ++at) {
    if (!runs_for_now(s_.member[at])) return true;
  }
  return false;
}

void Pass::try_unit(Index count) {
  const bool outdated = stale_requester(s_.unit[0]);
  depends_on_stale_ = depends_on_stale_ || outdated;
  if (count > 1 && outdated) {
    for (Index i = 0; i < count; ++i) { // each member for itself
      s_.member[0] = s_.unit[i];
      try_members(1);
    }
    return;
  }
  for (Index i = 0; i < count; ++i) s_.member[i] = s_.unit[i];
  try_members(count);
}

void Pass::try_members(Index count) {
  if (outdated_order(count) || !combine(count, true)) return refuse(count);
  if (!premature(count)) return grant(count);
  depends_on_stale_ = true;
  leave_combination(count);
  defer(count); // of a stale requester nothing gets here: the members in hand are those of the unit
}

/// What was granted before stays, the others wait for the runs to come.
void Pass::defer(Index count) {
  for (Index i = 0; i < count; ++i) {
    s_.member[0] = s_.unit[i];
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
  if (stale_granted_ == 0 || planted(Fault::nothing_is_deferred)) return false;
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
    if ((s_.now[group].flags & flag::granted) == 0 || !stale(group)) return false;
    const Index holder = s_.now[group].holder;
    return edge == nil || (!in_chain(holder, {edge, Along::now}) && before({holder, Along::now}, {edge, Along::now}));
  };
  for (const Index g : t_.list(c_.groups)) s_.group_marks[g] &= static_cast<std::uint8_t>(~mark::reached);
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
  return yes;
}

void Pass::grant(Index count) {
  for (Index at = 0; at < count; ++at) {
    const Index edge = s_.member[at], group = target(edge), begin = entries_begin(at), end = s_.member_entries[at];
    s_.now[group].holder = edge;
    s_.now[group].active = s_.member_provider[at];
    s_.now[group].flags |= flag::granted;
    plan_for(group, s_.member_provider[at], begin, end);
    for (Index i = begin; i < end; ++i) s_.now[s_.entry_group[i]].holder = s_.entry_need[i];
    claim_plan(begin, end);
  }
  for (Index at = 0; at < count; ++at) {
    const Index group = target(s_.member[at]);
    if (stale(group)) ++stale_granted_;
    become_candidates(group);
    waken(entries_begin(at), s_.member_entries[at]);
  }
  if (pushed_ && !planted(Fault::served_pushes_end)) keep_serving_pushes(count);
  // What serves one member of a unit serves all; below a stale group each member has only its own.
  depends_on_stale_ = depends_on_stale_ || (pushed_ && count > 1);
  leave_combination(count);
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

/// The pack edges of live plan groups become candidates for as long as these are stale.
void Pass::waken(Index begin, Index end) {
  for (Index i = begin; i < end; ++i) {
    const Index group = s_.entry_group[i];
    if (s_.last[group].active != nil && stale(group)) become_candidates(group);
  }
}

void Pass::refuse(Index count) {
  for (Index at = 0; at < count; ++at) s_.edge_marks[s_.member[at]] |= mark::refused;
  if (outdated_order(count)) { // it is not even tried
    keep_pushes(count);
    return explain(count, Why::outdated);
  }
  if (!combine(count, false)) {
    if (planted(Fault::blocked_units_push_on)) keep_pushes(count);
    return explain(count, Why::blocked);
  }
  depends_on_last_ = true;
  const Index unmet = collect_unmet(count);
  const bool early = stale_requester(s_.member[0]) || premature(count);
  depends_on_stale_ = depends_on_stale_ || early;
  leave_combination(count);
  explain(count, Why::waiting, s_.unmet[0]);
  if (early) return keep_pushes(count);
  for (Index i = 0; i < unmet; ++i) {
    if (somebody_satisfies(s_.unmet[i]) || planted(Fault::pushes_though_the_outside_decides)) continue;
    return; // it waits for the outside, and holds nobody back
  }
  push_for(count, unmet);
}

void Pass::explain(Index count, Why why, Index condition) {
  for (Index at = 0; at < count; ++at) s_.next_queued[s_.member[at]] = {why, condition};
}

/// Live groups that nobody claims are kept for an heir that is about to run.
void Pass::hand_over() {
  for (Index i = 0; i < s_.order_count[component_]; ++i) {
    const Index group = s_.order[c_.order + i];
    if (s_.last[group].active == nil || s_.now[group].holder != nil || stale_granted_ == 0 ||
        planted(Fault::nobody_inherits))
      continue;
    s_.reach[0] = group;
    if (reached_from_stale(1, nil)) hand_over(group);
  }
}

void Pass::hand_over(Index group) {
  const Index end = recall_plan(group);
  for (Index i = 0; i < end; ++i) {
    if (s_.now[s_.entry_group[i]].holder != nil) return;
  }
  depends_on_last_ = depends_on_stale_ = true;
  s_.now[group].holder = static_cast<Index>(t_.edges.size() + group);
  s_.now[group].active = s_.last[group].active;
  if (s_.last[group].planned != nil) plan_for(group, s_.last[group].planned, 0, end);
  for (Index i = 0; i < end; ++i) s_.now[s_.entry_group[i]].holder = s_.entry_need[i];
  claim_plan(0, end);
  become_candidates(group);
  waken(0, end);
  sweep();
}

/// Writes the plan that a group had after the last pass as entries from 0 on; returns how many.
Index Pass::recall_plan(Index group) {
  if (s_.last[group].planned == nil) return 0;
  Index end = 0;
  for (Index parent = nil;;) {
    const Index provider = parent == nil ? s_.last[group].planned : s_.entry_provider[parent];
    Index place = 0;
    Index owner = parent;
    Index of = provider;
    while (place >= t_.providers[of].needs.size()) { // the next need, depth first
      if (owner == nil) return end;
      place = static_cast<Index>(s_.entry_place[owner] + 1);
      owner = s_.entry_parent[owner];
      of = owner == nil ? s_.last[group].planned : s_.entry_provider[owner];
    }
    const Index need = t_.list(t_.providers[of].needs)[place], needed = t_.edges[need].target;
    const Index slot = slot_of(group, needed);
    s_.entry_group[end] = needed;
    s_.entry_need[end] = need;
    s_.entry_provider[end] = slot == nil ? t_.groups[needed].providers.begin : s_.last.plan[slot];
    s_.entry_parent[end] = owner;
    s_.entry_place[end] = place;
    parent = end++;
  }
}

/// What follows from the claims: who stays live for a need, which pushes are left and in force, and the order.
void Pass::finish() {
  Index count = 0;
  for (const Index g : t_.list(c_.groups)) {
    if (s_.now[g].holder == nil) continue;
    s_.next_order[c_.order + count++] = g;
    if (s_.now[g].active != nil || s_.last[g].active == nil) continue;
    depends_on_last_ = depends_on_stale_ = true;
    if (stale(g) || planted(Fault::unwanted_needs_live_on)) s_.now[g].active = s_.last[g].active;
  }
  s_.next_count[component_] = count;
  for (const Index g : t_.list(c_.groups)) {
    Push& push = s_.now[g].push;
    if (push.edge == nil) continue;
    depends_on_last_ = true;
    if (s_.now[g].holder == nil) {
      if (!asked_for(g) && !planted(Fault::pushes_outlive_requests)) push = Push{};
      continue;
    }
    const bool was_in_force = (s_.last[g].flags & flag::in_force) != 0;
    if (s_.now[g].active != push.provider || ((s_.now[g].flags & flag::granted) == 0 && !was_in_force) ||
        !applies(push, s_.now[g].holder))
      continue;
    s_.now[g].flags |= flag::in_force;
    if (!holds(push.condition)) s_.now[g].serves = {push.provider, push.condition};
  }
  sort({s_.next_order + c_.order, count}, Along::now);
}

/// By root or a live group.
bool Pass::asked_for(Index group) const {
  for (const Index edge : t_.list(t_.groups[group].requesters)) {
    const Index from = t_.edges[edge].requester;
    if (requested(edge) && (from == nil || s_.now[from].active != nil)) return true;
  }
  return false;
}

} // namespace director
