// Door: runtime/core/arbitration.hpp. Test: tests/runtime/core/arbitration_test.cpp.
//
// Section 4.4: the pass. Candidates are tried in order, unit by unit; what is granted adds the edges of its pack.
#include "runtime/core/arbitration.hpp"
#include "runtime/core/marks.hpp"
#include "runtime/core/planted.hpp"

namespace director {

void Pass::arbitrate() {
  for (const Index g : t_.list(c_.groups)) {
    s_.group_marks[g] = 0;
    s_.in_queue[g] &= static_cast<std::uint8_t>(~place::counts);
    pushed_ = pushed_ || s_.last[g].push.edge != nil;
  }
  depends_on_last_ = pushed_;
  sort_roots();
  do {
    clear();
    sweep();
  } while (denied_in_vain());
  hand_over();
  finish();
}

void Pass::clear() {
  candidates_ = denied_ = stale_granted_ = claimed_ = 0;
  next_ = nil;
  measured_ = true;
  pushing_ = false;
  for (const Index g : t_.list(c_.groups)) {
    s_.now[g] = Standing{};
    s_.group_marks[g] &= mark::forgotten;
    const Range slots = t_.groups[g].slots;
    for (Index slot = slots.begin; slot != slots.end; ++slot) s_.now.plan[slot] = nil;
  }
  root_ = s_.first_root[component_];
  for (const Index e : t_.list(c_.edges)) {
    s_.edge_marks[e] = t_.edges[e].requester == nil ? mark::candidate : std::uint8_t{0};
    s_.next_queued[e] = Queued{};
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

/// Tries candidates, the first in order first, until none is left.
void Pass::sweep() {
  for (Index first = first_candidate(); first != nil; first = first_candidate()) {
    if ((s_.edge_marks[first] & mark::candidate) == 0) continue; // it was tried as a member of a unit
    if (!may_ask(requester(first))) {
      drop_candidates(first);
      continue;
    }
    Index count = 0;
    const auto join = [&](Index edge) {
      s_.edge_marks[edge] = static_cast<std::uint8_t>((s_.edge_marks[edge] & ~mark::candidate) | mark::tried);
      Index at = count++; // members in order
      for (; at > 0 && compare_siblings({edge, false}, {s_.unit[at - 1], false}, true) < 0; --at)
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

/// A group's orders are outdated because of which granted group's; nil: because it is in limbo; `current`: they are
/// not.
Index Pass::stale_source(Index group) const {
  for (;;) {
    const Standing& now = s_.now[group];
    if (now.granted()) return (s_.group_marks[group] & mark::outdated) != 0 ? group : current;
    if (is_limbo(now.holder)) return nil;
    group = requester(now.holder); // held only as a need: while its requester is stale
    if (group == nil) return current;
  }
}

bool Pass::stale_requester(Index edge) const {
  const Index group = requester(edge);
  return group != nil && stale(group);
}

/// Its target was granted to it before this pass.
bool Pass::runs_for_now(Index edge) const {
  const Index group = target(edge);
  return s_.last[group].holder == edge && s_.last[group].granted();
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
  const Index from = requester(s_.unit[0]);
  const Index source = from == nil ? current : stale_source(from);
  const bool outdated = source != current;
  if (outdated && source != nil) s_.in_queue[source] |= place::counts;
  if (count > 1 && outdated) {
    for (Index i = 0; i < count; ++i) { // each member for itself
      s_.member[0] = s_.unit[i];
      if (!try_simple(1, true)) try_members(1);
    }
    return;
  }
  for (Index i = 0; i < count; ++i) s_.member[i] = s_.unit[i];
  if (!try_simple(count, outdated)) try_members(count);
}

/// The same as try_members, where there is nothing to choose: each target has one provider, which needs nothing, and
/// all goes well. False: it does not, and nothing was claimed.
bool Pass::try_simple(Index count, bool outdated) {
  for (Index at = 0; at < count; ++at) {
    const Index edge = s_.member[at], group = t_.edges[edge].target;
    const Range providers = t_.groups[group].providers;
    if (providers.size() != 1 || !t_.providers[providers.begin].needs.empty()) return false;
    if ((outdated || stale_granted_ != 0) && !runs_for_now(edge)) return false;
    if (!available(group, edge, true) || s_.enabled[providers.begin] == 0 || first_false(providers.begin, edge) != nil)
      return false;
    s_.member_provider[at] = providers.begin;
    s_.member_entries[at] = 0;
  }
  for (Index at = 0; at < count; ++at) {
    claim(t_.edges[s_.member[at]].target, s_.member[at]);
    now_granted(s_.member[at], s_.member_provider[at]);
  }
  for (Index at = 0; at < count; ++at) become_candidates(t_.edges[s_.member[at]].target);
  if (pushed_) keep_own_pushes(count);
  return true;
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
    const Index edge = s_.member[at], group = t_.edges[edge].target, begin = entries_begin(at),
                end = s_.member_entries[at];
    claim(group, edge);
    now_granted(edge, s_.member_provider[at]);
    plan_for(group, s_.member_provider[at], begin, end);
    for (Index i = begin; i < end; ++i) claim(s_.entry_group[i], s_.entry_need[i]);
    claim_plan(begin, end);
  }
  for (Index at = 0; at < count; ++at) {
    become_candidates(t_.edges[s_.member[at]].target);
    waken(entries_begin(at), s_.member_entries[at]);
  }
  if (pushed_) keep_own_pushes(count);
  leave_combination(count);
}

/// The target of an edge, which is claimed, runs in the provider chosen.
void Pass::now_granted(Index edge, Index provider) {
  const Index group = t_.edges[edge].target;
  Standing& now = s_.now[group];
  const Standing& last = s_.last[group];
  now.active = now.planned = provider;
  now.flags |= flag::granted;
  constexpr auto outdating = static_cast<std::uint8_t>(static_cast<std::uint8_t>(Reason::new_task) |
                                                       static_cast<std::uint8_t>(Reason::pushed));
  if ((s_.pending[group] & outdating) == 0 && s_.anew[edge] == 0 && edge == last.holder && provider == last.active)
    return;
  s_.group_marks[group] |= mark::outdated;
  ++stale_granted_;
}

void Pass::keep_own_pushes(Index count) {
  if (!planted(Fault::served_pushes_end)) keep_serving_pushes(count);
  // What serves one member of a unit serves all; below a stale group each member has only its own.
  depends_on_stale_ = depends_on_stale_ || count > 1;
}

void Pass::claim(Index group, Index edge) {
  Standing& now = s_.now[group];
  if (now.holder != nil) return; // for this very edge
  now.holder = edge;
  const Index from = requester(edge);
  s_.depth[group] = from == nil ? Index{1} : static_cast<Index>(s_.depth[from] + 1);
  s_.next_order[c_.order + claimed_++] = group;
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

} // namespace director
