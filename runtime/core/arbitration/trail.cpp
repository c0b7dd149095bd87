// Door: runtime/core/arbitration/arbitration.hpp. Test: tests/runtime/core/arbitration/trail_test.cpp.
// SPDX-License-Identifier: MIT
//
// What a pass looks at. A unit's decision depends on what units before it claimed, pushed and were denied, on its
// conditions and requests, on whose orders are outdated, and on the last result. So a pass goes along the order as the
// last one did, and decides only units that something different reaches (reach.cpp). All others stand as they stood.
//
// Between passes State::now is what State::last is. A pass opens the groups that it has to look at, each with all above
// it, and clears what is now of these alone. A group that is not opened stands with all below it: the walk passes it in
// one step, and from then on what they have is claimed.

#include "runtime/core/arbitration/arbitration.hpp"
#include "runtime/core/base/marks.hpp"
#include "runtime/core/base/fault_injection.hpp"

namespace director {

namespace {
void remove(Bits& from, std::uint8_t bits) { from &= static_cast<std::uint8_t>(~bits); }
} // namespace

/// The rows of a list of all components that are about this one; they leave it.
template <class ComponentOf, class Take>
void Pass::take_own(Index* list, Index& count, ComponentOf&& component_of, Take&& take) {
  Index left = 0;
  for (Index i = 0; i < count; ++i) {
    const Index row = list[i];
    if (component_of(row) == component_) {
      take(row);
    } else {
      list[left++] = row;
    }
  }
  count = left;
}

/// From what changed since the last pass to the units that it reaches.
void Pass::begin_trail() {
  const Index news = s_.news_count[component_];
  whole_ = news == nil;
  disturbed_ = false;
  walking_ = !whole_;
  opened_count_ = reached_count_ = kept_count_ = stale_kept_ = 0;
  const auto of_group = [&](Index g) { return s_.run_queue[g].component; };
  const auto of_edge = [&](Index e) { return s_.run_queue[s_.request[e].target].component; };
  if (whole_) {
    open_all();
    take_own(s_.flipped, flipped_count_, of_group, [](Index) {});
    take_own(s_.rerequested, rerequested_count_, of_edge, [](Index) {});
    return mark_pushers();
  }
  pushed_count_ = s_.pushed_count[component_];
  for (const Index g : pushed_groups()) {
    open(g);
    s_.group_marks[g] |= mark::listed;
  }
  mark_pushers();
  // The last result first: what is reached now belongs to the next one.
  Index* const rows = s_.news + c_.order;
  Index kept = 0;
  for (Index i = 0; i < news; ++i) {
    const Index g = rows[i];
    const std::uint8_t bits = s_.group_trail[g];
    remove(s_.group_trail[g], trail::disturbed | trail::again);
    if ((bits & trail::disturbed) != 0) take_up_last(g);
    if ((bits & trail::again) == 0) continue;
    if (can_stand(g)) {
      rows[kept++] = g;
      if (is_outdated(g)) ++stale_kept_;
    } else {
      open(g);
    }
  }
  take_own(s_.flipped, flipped_count_, of_group, [&](Index g) {
    remove(s_.group_trail[g], trail::touched);
    reach(g);
  });
  Index from = nil;
  take_own(s_.rerequested, rerequested_count_, of_edge, [&](Index e) {
    remove(s_.edge_trail[e], trail::changed);
    take_up(e, requester(e) != from);
    from = requester(e);
  });
  // Whose orders may be outdated: who is to run, and who was asked just now.
  const Counters& c = *s_.counters;
  const auto look = [&](Index g) {
    if (of_group(g) == component_ && !is_outdated(g) && outdates(g)) open(g);
  };
  for (Index g = c.queue_first; g != nil; g = s_.run_queue[g].runs_before) look(g);
  for (Index i = 0; i < c.touched_count; ++i) look(s_.touched[i]);
  kept_count_ = kept;
  if (disturbed_) open_waiting();
}

/// Something, if it is granted, makes the orders that the group gave outdated.
bool Pass::outdates(Index group) const {
  const Index holder = s_.last[group].holder;
  return (s_.run_queue[group].pending & reason::outdating) != 0 ||
         (holder != nil && !is_limbo(holder) && s_.request[holder].anew != 0);
}

/// What has to be looked at if something differs from the last pass, or when it has run, is left alone until then.
bool Pass::can_stand(Index group) const {
  const bool lives_for_need = !s_.last[group].granted() && s_.last[group].active != nil;
  if (lives_for_need || s_.lineage[group].top == nil || (is_outdated(group) && !outdates(group))) return false;
  const Range edges = t_.groups[group].edges;
  for (Index e = edges.begin; e != edges.end; ++e) {
    if ((s_.edge_trail[e] & trail::on_stale) != 0 || optional(e)) return false; // what is optional comes after all else
  }
  return true;
}

bool Pass::waits(Index group) const {
  const Range edges = t_.groups[group].edges;
  bool any = false;
  for (Index e = edges.begin; e != edges.end; ++e) any = any || (s_.edge_trail[e] & trail::waits) != 0;
  return any;
}

/// Who searched for somebody to push looked at much.
void Pass::open_waiting() {
  for (Index i = 0; i < kept_count_; ++i) {
    const Index g = s_.news[c_.order + i];
    if (!is_opened(g) && waits(g)) open(g);
  }
}

/// Something is, or may be, another than in the last pass.
void Pass::disturb() {
  if (disturbed_) return;
  disturbed_ = true;
  open_waiting();
}

void Pass::open_all() {
  pushed_count_ = s_.on_last[component_] = 0;
  for (const Index g : t_.list(c_.groups)) {
    s_.group_trail[g] = trail::opened;
    s_.group_marks[g] = 0;
    if (s_.last[g].push.edge != nil) list_push(g);
    clear(g);
  }
  for (const Index e : t_.list(c_.edges)) s_.edge_marks[e] = s_.edge_trail[e] = 0;
}

/// This pass looks at the group, and so at all above it.
void Pass::open(Index group) {
  if (is_opened(group) || (s_.last[group].holder != nil && is_passed(group))) return;
  for (;;) {
    s_.group_trail[group] |= trail::opened;
    remove(s_.group_marks[group], mark::outdated);
    s_.opened[c_.order + opened_count_++] = group;
    clear(group);
    group = requester_of_holder(s_.last[group]);
    if (group == nil || is_opened(group)) return;
  }
}

/// Who made a push in the last assignment is asked what becomes of it.
void Pass::mark_pushers() {
  for (const Index g : pushed_groups()) {
    const Index pusher = s_.last[g].push.edge;
    if (pusher == nil) continue;
    s_.edge_marks[pusher] |= mark::pushes;
    if (requester(pusher) != nil) open(requester(pusher));
  }
}

/// A unit of this one edge stands as it stood.
void Pass::repeat(Index edge) {
  s_.edge_marks[edge] |= mark::visited;
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
    claim_plan(0, end);
  } else if ((traits & trait::simple) == 0) {
    grant_plain(edge, provider);
  } else {
    claim(group, edge);
    now_granted(edge, provider);
  }
}

/// What the decision about an edge rests on; the bits of trail::kept that there were are forgotten.
void Pass::rest_on(Index edge, std::uint8_t bits) {
  Bits& trail = s_.edge_trail[edge];
  const bool was = (trail & trail::on_last) != 0, is = (bits & trail::on_last) != 0;
  if (is && !was) ++s_.on_last[component_];
  if (was && !is) --s_.on_last[component_];
  trail = static_cast<std::uint8_t>((trail & ~trail::kept) | bits);
}

/// What its decision looks at and may lose is cleared first.
void Pass::begin_followed(Index count) {
  on_last_ = depends_on_last_, on_stale_ = depends_on_stale_;
  depends_on_last_ = depends_on_stale_ = false;
  for (Index at = 0; at < count; ++at) {
    const Index edge = s_.unit[at], group = target(edge);
    rest_on(edge, 0);
    if (s_.last[group].holder != edge) continue;
    open(group);
    if (!runs_for_now(edge) || (s_.traits[group] & trait::simple) != 0) continue;
    const Index end = entries_of(group, s_.last);
    for (Index i = 0; i < end; ++i) open(s_.entry_group[i]);
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
    rest_on(edge, static_cast<std::uint8_t>(bits | (s_.edge_trail[edge] & trail::waits)));
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
  bool lost = false;
  for (const Index g : pushed_groups()) {
    const Push &now = s_.now[g].push, &last = s_.last[g].push;
    if (now == last) continue;
    const bool was_ours = ours(last.edge);
    lost = lost || was_ours;
    if (was_ours || ours(now.edge)) reach(g);
  }
  // Of its pushes those stay that serve another: so it is asked again what becomes of the rest.
  for (Index at = 0; lost && at < count; ++at) s_.edge_trail[s_.unit[at]] |= trail::on_stale;
}

void Pass::compare_member(Index edge) {
  const Index group = target(edge);
  const GroupAssignment &now = s_.now[group], &last = s_.last[group];
  const bool runs = is_opened(group) && now.holder == edge && now.granted(), ran = runs_for_now(edge);
  if (!runs && !ran) return;
  // Below outdated orders it was tried as what ran before.
  if (!runs) rest_on(edge, static_cast<std::uint8_t>((s_.edge_trail[edge] & trail::kept) | trail::on_last));
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
  if (!whole_ && s_.now[group].holder != s_.last[group].holder) move(group);
}

/// A condition of one of its providers flipped, or it is to be looked at as if one had.
void Pass::touch_group(Index group) {
  if ((s_.group_trail[group] & trail::touched) != 0) return;
  s_.group_trail[group] |= trail::touched;
  s_.flipped[flipped_count_++] = group;
}

/// What nobody visited is not queued. What the pass did is noted for the next one, and its marks are removed.
void Pass::end_trail() {
  const auto leave = [&](Index edge) {
    if ((s_.edge_marks[edge] & mark::visited) == 0) s_.queued[edge] = Queued{};
  };
  for (const Index e : whole_ ? t_.list(c_.edges) : std::span<const Index>{}) leave(e);
  Index& news = s_.news_count[component_] = nil;
  if (!is_followed()) return;
  for (Index i = 0; i < denied_; ++i) { // what was forgotten counts again in the next pass
    if ((s_.group_marks[s_.denied[i]] & mark::forgotten) != 0) touch_group(s_.denied[i]);
  }
  for (Index i = 0; i < reached_count_; ++i) {
    const Index e = s_.reached[i], from = requester(e);
    if (!whole_ && (from == nil || is_opened(from))) leave(e); // otherwise it stands as it stood
    s_.edge_trail[e] &= trail::kept;
  }
  news = 0;
  for (Index i = 0; i < kept_count_; ++i) {
    const Index g = s_.news[c_.order + i];
    if (is_opened(g)) continue;
    s_.group_trail[g] |= trail::again;
    s_.news[c_.order + news++] = g;
  }
  Index& pushed = s_.pushed_count[component_] = 0;
  for (const Index g : pushed_groups()) {
    if (s_.now[g].push.edge != nil) s_.pushed[c_.order + pushed++] = g;
  }
  clear_marks();
  for (Index at = limbo_; at < placed_; ++at) {
    const Index g = s_.next_order[c_.order + at];
    s_.group_trail[g] |= trail::again;
    s_.lineage[g].top = nil;
  }
  for (const Index g : opened()) {
    const GroupAssignment& now = s_.now[g];
    Bits& bits = s_.group_trail[g];
    if (now.holder != nil && has_to_be_looked_at(g)) bits |= trail::again;
    if ((bits & (trail::disturbed | trail::again)) != 0) s_.news[c_.order + news++] = g;
    remove(bits, trail::opened | trail::moved);
    s_.group_marks[g] &= mark::differs | mark::outdated;
  }
}

/// By the next pass: something of it is decided again whatever happens, or what is below it stands apart from it.
bool Pass::has_to_be_looked_at(Index group) const {
  if (injected(Fault::what_is_always_decided_is_overlooked)) return false;
  const GroupAssignment& now = s_.now[group];
  if (is_outdated(group) || (!now.granted() && now.active != nil)) return true;
  const Range edges = t_.groups[group].edges;
  for (Index e = edges.begin; e != edges.end; ++e) {
    if ((s_.edge_trail[e] & (trail::on_stale | trail::waits)) != 0 || optional(e)) return true;
  }
  return false;
}

/// On edges, and where the walk passed.
void Pass::clear_marks() {
  const auto clear_edge = [&](Index e) {
    s_.edge_marks[e] = 0;
    remove(s_.group_trail[t_.edges[e].target], trail::passed);
  };
  for (const Index e : t_.list(c_.edges)) {
    if (t_.edges[e].requester != nil) break; // those of root come first
    clear_edge(e);
  }
  for (const Index g : opened()) {
    const Range edges = t_.groups[g].edges;
    for (Index e = edges.begin; e != edges.end; ++e) clear_edge(e);
  }
}

} // namespace director
