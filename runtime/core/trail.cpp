// Door: runtime/core/arbitration.hpp. Test: tests/runtime/core/trail_test.cpp.
// SPDX-License-Identifier: MIT
//
// What is decided again. A unit's decision depends on what units before it claimed, pushed and were denied, on its
// conditions and requests, on whose orders are outdated, and on the last result. So a pass goes along the order as the
// last one did, and decides only units that something different reaches: an input, or a group (its claim, plan, push or
// place in the order) that is another than in the last pass. All others stand as they stood.

#include "runtime/core/arbitration.hpp"
#include "runtime/core/marks.hpp"
#include "runtime/core/planted.hpp"

namespace director {

/// From what changed since the last pass to the units that it reaches.
void Pass::begin_trail() {
  disturbed_ = false;
  moved_ = 0;
  followed_ = c_.groups.size() > most_decided_whole_;
  if (whole_) {
    s_.known[component_] = followed_ ? 1 : 0;
    for (const Index g : t_.list(c_.groups)) s_.group_trail[g] = 0;
    return;
  }
  // The last result first: what is reached now belongs to the next one.
  const std::span<const Index> groups{s_.disturbed, disturbed_count_};
  for (const Index g : groups) {
    if ((s_.group_trail[g] & trail::disturbed) != 0) take_up_last(g);
    s_.group_trail[g] &= static_cast<std::uint8_t>(~(trail::disturbed | trail::moved));
  }
  for (const Index g : groups) {
    if ((s_.group_trail[g] & trail::touched) == 0) continue;
    s_.group_trail[g] &= static_cast<std::uint8_t>(~trail::touched);
    reach(g);
  }
  for (const Index e : t_.list(c_.edges)) {
    if ((s_.edge_trail[e] & trail::changed) != 0) take_up(e);
  }
}

/// The edge is requested at another level than before, or not any more.
void Pass::take_up(Index edge) {
  const Index group = target(edge), from = requester(edge);
  s_.edge_trail[edge] |= trail::reached;
  if (from != nil && !planted(Fault::other_members_are_overlooked)) { // its unit has another member
    const Range edges = t_.groups[from].edges;
    for (Index e = edges.begin; e != edges.end; ++e) s_.edge_trail[e] |= trail::reached;
  }
  reach(group);
  reach_pushes_of(edge);
  if (s_.last[group].holder == edge) move(group);
}

/// The last pass changed where the group stands. Who looks at the last result looks at another one now.
void Pass::take_up_last(Index group) {
  disturbed_ = true;
  if (planted(Fault::the_last_result_is_overlooked)) return;
  for (const Index user : t_.list(t_.groups[group].users)) {
    for (const Index e : t_.list(t_.groups[user].requesters)) {
      if (pushed_ || (s_.edge_trail[e] & trail::on_last) != 0) s_.edge_trail[e] |= trail::reached;
    }
  }
  const Index pusher = s_.last[group].push.edge;
  if (pusher != nil) s_.edge_trail[pusher] |= trail::reached;
}

/// Who may look at the group is decided again.
void Pass::reach(Index group) {
  if ((s_.group_trail[group] & trail::disturbed) != 0) return;
  s_.group_trail[group] |= trail::disturbed;
  disturbed_ = true;
  for (const Index user : t_.list(t_.groups[group].users)) {
    if (user != group && planted(Fault::who_uses_it_is_overlooked)) continue;
    for (const Index e : t_.list(t_.groups[user].requesters)) s_.edge_trail[e] |= trail::reached;
  }
  const Index pusher = s_.last[group].push.edge;
  if (pusher != nil) s_.edge_trail[pusher] |= trail::reached;
}

/// What holds the group, or where that stands in the order, is another: so are the places of all below it.
void Pass::move(Index group) {
  const Index begin = moved_;
  const auto add = [&](Index g) {
    reach(g);
    if ((s_.group_trail[g] & trail::moved) != 0) return;
    s_.group_trail[g] |= trail::moved;
    s_.moved[moved_++] = g;
  };
  add(group);
  for (Index i = begin; i < moved_ && !planted(Fault::what_is_below_is_overlooked); ++i) {
    const Range edges = t_.groups[s_.moved[i]].edges;
    for (Index e = edges.begin; e != edges.end; ++e) {
      s_.edge_trail[e] |= trail::reached;
      reach_pushes_of(e);
      if (s_.last[t_.edges[e].target].holder == e) add(t_.edges[e].target);
    }
  }
}

void Pass::reach_pushes_of(Index edge) {
  for (const Index g : pushed_groups()) {
    if (s_.last[g].push.edge == edge) reach(g);
  }
}

/// A unit of this one edge stands as it stood.
void Pass::repeat(Index edge) {
  s_.edge_marks[edge] |= mark::visited;
  if ((s_.edge_trail[edge] & trail::on_last) != 0) depends_on_last_ = true;
  if (runs_for_now(edge)) {
    repeat_grant(edge);
  } else {
    s_.edge_marks[edge] |= mark::refused;
  }
  if ((s_.edge_marks[edge] & mark::pushes) == 0) return;
  s_.member[0] = edge;
  keep_pushes(1);
}

void Pass::repeat_grant(Index edge) {
  const Index group = target(edge), provider = s_.last[group].active;
  const std::uint8_t traits = s_.traits[group];
  if ((traits & trait::flat) == 0) {
    const Index end = entries_of(group, s_.last);
    claim(group, edge);
    now_granted(edge, provider);
    plan_for(group, provider, 0, end);
    for (Index i = 0; i < end; ++i) claim(s_.entry_group[i], s_.entry_need[i]);
    needs_ = needs_ || end != 0;
    claim_plan(0, end);
  } else if ((traits & trait::simple) == 0) {
    grant_plain(edge, provider);
  } else {
    claim(group, edge);
    now_granted(edge, provider);
  }
}

/// What the decision rests on is noted, and what came out otherwise than in the last pass reaches others.
void Pass::compare_with_last(Index count) {
  const auto bits = static_cast<std::uint8_t>((depends_on_last_ ? trail::on_last : 0) |
                                              (depends_on_stale_ ? trail::on_stale : 0));
  depends_on_last_ = depends_on_last_ || on_last_;
  depends_on_stale_ = depends_on_stale_ || on_stale_;
  bool pushing = false;
  for (Index at = 0; at < count; ++at) {
    const Index edge = s_.unit[at];
    s_.edge_trail[edge] |= bits;
    pushing = pushing || (s_.edge_marks[edge] & mark::pushes) != 0;
    compare_member(edge);
  }
  if (!pushing && !pushing_) return;
  const auto ours = [&](Index edge) {
    for (Index at = 0; at < count; ++at) {
      if (s_.unit[at] == edge) return true;
    }
    return false;
  };
  for (const Index g : pushed_groups()) {
    const Push &now = s_.now[g].push, &last = s_.last[g].push;
    if (now != last && (ours(now.edge) || ours(last.edge))) reach(g);
  }
}

void Pass::compare_member(Index edge) {
  const Index group = target(edge);
  const Standing &now = s_.now[group], &last = s_.last[group];
  const bool runs = now.holder == edge && now.granted(), ran = runs_for_now(edge);
  if (!runs && !ran) return;
  if (!runs) s_.edge_trail[edge] |= trail::on_last; // below outdated orders it was tried as what ran before
  compare_claim(group);
  bool other = runs != ran || now.active != last.active || now.planned != last.planned;
  const Range slots = t_.groups[group].slots;
  for (Index slot = slots.begin; slot != slots.end; ++slot)
    other = other || s_.now.plan[slot] != s_.last.plan[slot];
  if (other) reach(group);
  if ((s_.traits[group] & trait::simple) != 0) return;
  const auto compare_plan = [&](const Assignment& of) {
    const Index end = entries_of(group, of);
    for (Index i = 0; i < end; ++i) {
      compare_claim(s_.entry_group[i]);
      if (other) reach(s_.entry_group[i]); // it may be needed otherwise
    }
  };
  if (ran) compare_plan(s_.last);
  if (runs) compare_plan(s_.now);
}

void Pass::compare_claim(Index group) {
  if (s_.now[group].holder != s_.last[group].holder) move(group);
}

/// What nobody visited is not queued. What reached units of this pass is forgotten, and what it changed stays for the
/// next one.
void Pass::end_trail() {
  for (Index i = 0; i < denied_; ++i) { // what was forgotten counts again in the next pass
    if ((s_.group_marks[s_.denied[i]] & mark::forgotten) != 0) s_.group_trail[s_.denied[i]] |= trail::touched;
  }
  for (const Index e : t_.list(c_.edges)) {
    if ((s_.edge_marks[e] & mark::visited) == 0) s_.queued[e] = Queued{};
    s_.edge_trail[e] &= trail::kept;
  }
}

} // namespace director
