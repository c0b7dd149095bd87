// Door: runtime/core/arbitration/arbitration.hpp. Test: tests/runtime/core/arbitration/arbitration_test.cpp.
// SPDX-License-Identifier: MIT
//
// Who is tried next: a walk along the order of edges.
#include "runtime/core/arbitration/arbitration.hpp"
#include "runtime/core/base/heap_sort.hpp"
#include "runtime/core/base/marks.hpp"
#include "runtime/core/base/fault_injection.hpp"

namespace director {

/// Edges of root stay linked in order from pass to pass: few are in another place than before, and mostly none is.
void Pass::sort_roots() {
  if ((s_.component[component_] & work::reordered) == 0) return;
  s_.component[component_] &= static_cast<std::uint8_t>(~work::reordered);
  const auto goes_first = [&](Index a, Index b) {
    return compare_siblings({a, optional(a)}, {b, optional(b)}, true) < 0;
  };
  Index* link = &s_.first_root[component_];
  Index last = nil, moved = 0;
  for (Index e = *link; e != nil;) {
    const Index following = s_.next_root[e];
    if (last != nil && goes_first(e, last)) {
      s_.candidate[moved++] = e;
    } else {
      *link = e;
      link = &s_.next_root[e];
      last = e;
    }
    e = following;
  }
  *link = nil;
  heap_sort({s_.candidate, moved}, goes_first);
  link = &s_.first_root[component_];
  for (Index i = 0; i < moved; ++i) {
    const Index e = s_.candidate[i];
    while (*link != nil && goes_first(*link, e)) link = &s_.next_root[*link];
    s_.next_root[e] = *link;
    *link = e;
    link = &s_.next_root[e];
  }
}

/// Tries candidates, the first in order first, until none is left, and puts down who is claimed in the order in which
/// the edges stand. Below a mandatory edge that order is the tree's: an edge, all that is below it, its next sibling.
/// What is optional waits in a heap until all else was tried.
void Pass::sweep() {
  Index root = s_.first_root[component_];
  for (; root != nil && !optional(root); root = s_.next_root[root]) {
    if (s_.request[root].level == nil) continue;
    visit_root(root);
    walk_on();
  }
  if (root != nil || postponed_ != 0) sweep_optional(root);
}

/// What is in limbo, after all else.
void Pass::sweep_below(Index group) {
  place(group);
  walk_on();
  sweep_optional(nil);
}

void Pass::sweep_optional(Index root) {
  for (;;) {
    while (root != nil && s_.request[root].level == nil) root = s_.next_root[root];
    const bool waits = postponed_ != 0;
    if (root == nil && !waits) return;
    if (root != nil && (!waits || goes_first(root, heap_at(0)))) {
      visit_root(root);
      root = s_.next_root[root];
    } else {
      const Index edge = first_of_heap();
      visit(edge, s_.edge_marks[edge]);
    }
    walk_on();
  }
}

inline void Pass::walk_on() {
  while (ahead_ != 0) {
    const Index edge = s_.candidate[--ahead_];
    visit(edge, s_.edge_marks[edge]);
  }
}

inline void Pass::visit_root(Index edge) { visit(edge, static_cast<std::uint8_t>(s_.edge_marks[edge] | mark::alone)); }

inline void Pass::visit(Index edge, std::uint8_t marks) {
  const Index group = t_.edges[edge].target;
  if ((marks & mark::tried) == 0 && s_.request[edge].level != nil) {
    if ((marks & mark::alone) == 0) {
      try_unit(edge, (marks & mark::below_stale) != 0);
    } else if (runs_on(edge)) {
      s_.edge_marks[edge] |= mark::visited;
      claim(group, edge);
      now_granted(edge, t_.groups[group].providers.begin);
    } else if (stands(edge)) {
      const bool was_held = s_.last[group].holder == edge;
      if ((marks & mark::pushes) != 0 || (was_held && is_opened(group))) {
        repeat(edge);
      } else if (was_held) {
        s_.edge_marks[edge] |= mark::visited;
        return pass(group);
      } else {
        s_.edge_marks[edge] |= mark::visited | mark::refused;
      }
    } else if ((marks & (mark::below_stale | mark::pushes)) == 0 && taken(edge) && !runs_for_now(edge)) {
      block_alone(edge);
    } else {
      s_.unit[0] = edge;
      try_alone(edge, (marks & mark::below_stale) != 0);
    }
  }
  if (s_.now[group].holder == edge && is_opened(group)) place(group);
}

/// It was granted, there is one way to grant it, which has no conditions and needs nothing, and nothing is in its way.
inline bool Pass::runs_on(Index edge) const {
  const Index group = t_.edges[edge].target;
  return is_opened(group) && s_.traits[group] == (trait::flat | trait::simple) && runs_for_now(edge) &&
         !taken(edge) && (s_.edge_marks[edge] & mark::pushes) == 0 &&
         s_.enabled[t_.groups[group].providers.begin] != 0;
}

inline void Pass::try_alone(Index edge, bool outdated) {
  begin_decision(1);
  decide_alone(edge, outdated);
  end_decision(1);
}

inline void Pass::decide_alone(Index edge, bool outdated) {
  take_in_hand(edge);
  switch (try_plain(edge, outdated)) {
  case Tried::granted: return;
  case Tried::refused: return refuse(1);
  case Tried::unclear: return try_members(1, outdated);
  }
}

/// The members of a unit, in order, the first of which is this one; the others stand ahead. Below a stale group each is
/// tried for itself.
void Pass::try_unit(Index edge, bool outdated) {
  Index count = 0;
  s_.unit[count++] = edge;
  const Index from = requester(edge);
  for (Index i = ahead_; i > 0; --i) {
    const Index e = s_.candidate[i - 1];
    if (requester(e) != from) break;
    if (s_.request[e].level == nil || (s_.edge_marks[e] & mark::alone) != 0) continue;
    s_.edge_marks[e] |= mark::tried;
    s_.unit[count++] = e;
  }
  bool as_before = true;
  for (Index i = 0; i < count; ++i) as_before = as_before && stands(s_.unit[i]);
  for (Index i = 0; as_before && i < count; ++i) repeat(s_.unit[i]);
  if (as_before) return;
  begin_decision(count);
  if (outdated || count == 1) {
    for (Index i = 0; i < count; ++i) decide_alone(s_.unit[i], outdated);
  } else {
    for (Index i = 0; i < count; ++i) s_.member[i] = s_.unit[i];
    if (!try_simple(count)) try_members(count, false);
  }
  end_decision(count);
}

/// The next in order, and what it asks for or needs stands ahead.
inline void Pass::place(Index group) {
  ++work_;
  if (s_.last[group].holder != nil) ++inherited_;
  if (is_followed()) {
    leave_to(requester_of_holder(s_.now[group]));
    top_ = group;
  }
  Index at = placed_;
  if (injected(Fault::ancestors_are_equals) && at != 0 && s_.next_order[c_.order + at - 1] == requester(s_.now[group].holder)) {
    put(s_.next_order[c_.order + at - 1], at);
    --at;
  }
  put(group, at);
  ++placed_;
  if (!t_.groups[group].edges.empty()) look_ahead(group);
}

/// The group, and all below it, stand as they stood.
void Pass::pass(Index group) {
  leave_to(requester_of_holder(s_.last[group]));
  s_.group_trail[group] |= trail::passed;
  const Index from = s_.place[group], count = s_.extent[group];
  if (from != placed_) {
    for (Index i = 0; i < count; ++i) put(s_.order[c_.order + from + i], static_cast<Index>(placed_ + i));
  }
  placed_ = static_cast<Index>(placed_ + count);
  inherited_ = static_cast<Index>(inherited_ + count);
}

/// What is placed next is below this group, nil being root: of what was placed and does not lie above, all is placed.
void Pass::leave_to(Index group) {
  while (top_ != group && top_ != nil) {
    s_.extent[top_] = static_cast<Index>(placed_ - s_.place[top_]);
    top_ = requester_of_holder(s_.now[top_]);
  }
}

/// Of what is held for a need only, the pack counts while it waits for its orders, and no longer.
void Pass::look_ahead(Index group) {
  const Index source = stale_source(group);
  const bool is_stale = source != current, asks = is_stale || s_.now[group].granted();
  std::uint8_t marks = asks ? std::uint8_t{0} : mark::tried;
  if (is_stale) marks |= mark::below_stale;
  const auto known = static_cast<std::uint8_t>((is_stale ? trail::stale : 0) | (asks ? trail::asks : 0));
  const bool other = (s_.group_trail[group] & (trail::stale | trail::asks)) != known;
  s_.group_trail[group] &= static_cast<std::uint8_t>(~(trail::stale | trail::asks));
  s_.group_trail[group] |= known;
  const Index base = ahead_;
  Index together = 0, member = nil;
  bool in_order = true, asked = false;
  const Range edges = t_.groups[group].edges;
  for (Index e = edges.end; e != edges.begin;) {
    --e;
    const Index level = s_.request[e].level;
    if (other && !whole_ && level != nil && !injected(Fault::outdated_orders_are_overlooked)) {
      reach_edge(e);
      if (!asks) reach_pushes_of(e);
    }
    if (level == nil || !asks) {
      if (holder_now(t_.edges[e].target) != e) {
        if (other && !whole_ && s_.last[t_.edges[e].target].holder == e && !injected(Fault::lost_needs_are_overlooked)) move(t_.edges[e].target);
        continue;
      }
      if (level == nil) {
        in_order = look_ahead_to(e, base) && in_order;
        continue;
      }
    }
    asked = true;
    const Level& row = t_.levels[level];
    std::uint8_t all = marks;
    if (row.optional || row.apart || injected(Fault::members_for_themselves)) {
      all |= mark::alone;
    } else {
      ++together;
      member = e;
    }
    s_.edge_marks[e] |= all;
    if (row.optional) {
      postpone(e);
    } else {
      in_order = look_ahead_to(e, base) && in_order;
    }
  }
  if (together == 1) s_.edge_marks[member] |= mark::alone;
  if (is_stale && source != nil && asked) s_.run_queue[source].counts = 1;
  if (in_order) return;
  heap_sort({s_.candidate + base, static_cast<std::size_t>(ahead_ - base)}, [&](Index a, Index b) {
    return compare_siblings({b, false}, {a, false}, true) < 0;
  });
}

/// It comes before what stands ahead of its siblings?
inline bool Pass::look_ahead_to(Index edge, Index base) {
  const bool in_order = ahead_ == base || compare_siblings({edge, false}, {s_.candidate[ahead_ - 1], false}, true) < 0;
  s_.candidate[ahead_++] = edge;
  return in_order;
}

/// The same as try_members where what is needed is simple and nothing can stand in the way but what is claimed already.
[[gnu::always_inline]] inline Pass::Tried Pass::try_plain(Index edge, bool outdated) {
  const Index group = t_.edges[edge].target;
  const GroupAssignment& last = s_.last[group];
  const bool as_before = last.holder == edge && last.granted();
  const std::uint8_t traits = s_.traits[group];
  if ((traits & trait::flat) == 0 || taken(edge)) return Tried::unclear;
  if (!as_before && (outdated || stale_granted_ != 0)) return Tried::unclear;
  if (disputed_) return Tried::unclear;
  const Range providers = t_.groups[group].providers;
  for (Index place = 0; place != providers.size(); ++place) {
    const Index p = s_.now[group].push.edge == nil ? static_cast<Index>(providers.begin + place) : preferred(group, place, edge);
    if (s_.enabled[p] == 0 || (outdated && p != last.active)) continue;
    if ((traits & trait::conditional) != 0 && first_false(p, edge) != nil) continue;
    if ((traits & trait::simple) == 0) {
      if (!needs_are_free(edge, t_.providers[p].needs)) continue;
      grant_plain(edge, p);
    } else {
      claim(group, edge);
      now_granted(edge, p);
    }
    if ((s_.edge_marks[edge] & mark::pushes) != 0) keep_pushes_of_plain(edge, p);
    return Tried::granted;
  }
  return injected(Fault::disabled_providers_run) ? Tried::unclear : Tried::refused;
}

/// What a provider of the flat target of `edge` needs: nobody has claimed it, and it can run.
bool Pass::needs_are_free(Index edge, Range needs) const {
  const auto is_free = [&](Index need) {
    const Index group = t_.edges[need].target, provider = t_.groups[group].providers.begin;
    return !taken(need) && s_.enabled[provider] != 0 &&
           ((s_.traits[group] & trait::conditional) == 0 || first_false(provider, need) == nil);
  };
  bool all = true;
  Index& above = s_.trial[t_.edges[edge].target]; // the chains of what it needs go through it
  above = edge;
  for (const Index need : t_.list(needs)) all = all && is_free(need);
  above = nil;
  return all;
}

void Pass::grant_plain(Index edge, Index provider) {
  claim(t_.edges[edge].target, edge);
  now_granted(edge, provider);
  for (const Index need : t_.list(t_.providers[provider].needs)) {
    const Index group = t_.edges[need].target;
    claim(group, need);
    s_.now[group].flags |= flag::needed;
    if (!s_.now[group].granted()) s_.now[group].planned = t_.groups[group].providers.begin;
  }
}

void Pass::keep_pushes_of_plain(Index edge, Index provider) {
  Index end = 0;
  for (const Index need : t_.list(t_.providers[provider].needs))
    s_.entry_provider[end++] = t_.groups[t_.edges[need].target].providers.begin;
  s_.member[0] = edge;
  s_.member_provider[0] = provider;
  s_.member_entries[0] = end;
  keep_own_pushes(1);
}

// The heap stands at the end of the same rows: an edge is ahead, or postponed.

void Pass::postpone(Index edge) {
  Index at = postponed_++;
  while (at > 0) {
    const auto parent = static_cast<Index>((at - 1) / 2);
    if (!goes_first(edge, heap_at(parent))) break;
    heap_at(at) = heap_at(parent);
    at = parent;
  }
  heap_at(at) = edge;
}

Index Pass::first_of_heap() {
  const Index first = heap_at(0), moved = heap_at(--postponed_);
  Index at = 0;
  for (;;) {
    auto child = static_cast<Index>(2 * at + 1);
    if (child >= postponed_) break;
    const auto other = static_cast<Index>(child + 1);
    if (other < postponed_ && goes_first(heap_at(other), heap_at(child))) child = other;
    if (goes_first(moved, heap_at(child))) break;
    heap_at(at) = heap_at(child);
    at = child;
  }
  if (postponed_ != 0) heap_at(at) = moved;
  return first;
}

} // namespace director
