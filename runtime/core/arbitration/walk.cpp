// docs/semantics.md, section 4.4: which candidate is tried next.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/walk.hpp"

#include "runtime/core/arbitration/grant.hpp"
#include "runtime/core/arbitration/order.hpp"
#include "runtime/core/arbitration/push.hpp"
#include "runtime/core/arbitration/staleness.hpp"
#include "runtime/core/arbitration/trail.hpp"
#include "runtime/core/base/heap_sort.hpp"

namespace director::arbitration {

namespace {

/// It was granted, there is one way to grant it, which has no conditions and needs nothing, and nothing is in its way.
inline bool runs_on(const Context& x, Index edge) {
  const Index group = x.t.edges[edge].target;
  return is_opened(x, group) && x.t.groups[group].simple && runs_for_now(x, edge) &&
         !taken(x, edge) && (x.s.edge_marks[edge] & mark::pushes) == 0 &&
         x.s.enabled[x.t.groups[group].providers.begin] != 0;
}

inline void try_alone(Context& x, Index edge, bool outdated) {
  begin_decision(x, 1);
  decide_alone(x, edge, outdated);
  end_decision(x, 1);
}

/// The members of a unit, in order, the first of which is this one; the others stand ahead. Below a stale group each is
/// tried for itself.
void try_unit(Context& x, Index edge, bool outdated) {
  Index count = 0;
  x.s.unit[count++] = edge;
  const Index from = requester(x, edge);
  for (Index i = x.ahead; i > 0; --i) {
    const Index e = x.s.candidate[i - 1];
    if (requester(x, e) != from) break;
    if (x.s.request[e].level == nil || (x.s.edge_marks[e] & mark::alone) != 0) continue;
    x.s.edge_marks[e] |= mark::tried;
    x.s.unit[count++] = e;
  }
  bool as_before = true;
  for (Index i = 0; i < count; ++i) as_before = as_before && stands(x, x.s.unit[i]);
  for (Index i = 0; as_before && i < count; ++i) repeat(x, x.s.unit[i]);
  if (as_before) return;
  begin_decision(x, count);
  if (outdated || count == 1) {
    for (Index i = 0; i < count; ++i) decide_alone(x, x.s.unit[i], outdated);
  } else {
    for (Index i = 0; i < count; ++i) x.s.member[i] = x.s.unit[i];
    try_members(x, count, false);
  }
  end_decision(x, count);
}

/// It comes before what stands ahead of its siblings?
inline bool look_ahead_to(Context& x, Index edge, Index base) {
  const bool in_order =
      x.ahead == base || compare_siblings(x, {edge, false}, {x.s.candidate[x.ahead - 1], false}, true) < 0;
  x.s.candidate[x.ahead++] = edge;
  return in_order;
}

inline Index& heap_at(Context& x, Index at) { return x.s.candidate[x.t.edges.size() - 1 - at]; }

void postpone(Context& x, Index edge) {
  Index at = x.postponed++;
  while (at > 0) {
    const auto parent = static_cast<Index>((at - 1) / 2);
    if (!goes_first(x, edge, heap_at(x, parent))) break;
    heap_at(x, at) = heap_at(x, parent);
    at = parent;
  }
  heap_at(x, at) = edge;
}

/// Of what is held for a need only, the pack counts while it waits for its orders, and no longer.
void look_ahead(Context& x, Index group) {
  const Index source = stale_source(x, group);
  const bool is_stale = source != up_to_date, asks = is_stale || x.s.now[group].granted();
  std::uint8_t marks = asks ? std::uint8_t{0} : mark::tried;
  if (is_stale) marks |= mark::below_stale;
  const auto known = static_cast<std::uint8_t>((is_stale ? trail::stale : 0) | (asks ? trail::asks : 0));
  const bool other = (x.s.group_trail[group] & (trail::stale | trail::asks)) != known;
  x.s.group_trail[group] &= static_cast<std::uint8_t>(~(trail::stale | trail::asks));
  x.s.group_trail[group] |= known;
  const Index base = x.ahead;
  Index together = 0, member = nil;
  bool in_order = true, asked = false;
  const Range edges = x.t.groups[group].edges;
  for (Index e = edges.end; e != edges.begin;) {
    --e;
    const Index level = x.s.request[e].level;
    if (other && !x.whole && level != nil && !injected(Fault::outdated_orders_are_overlooked)) {
      reach_edge(x, e);
      if (!asks) reach_pushes_of(x, e);
    }
    if (level == nil || !asks) {
      if (holder_now(x, x.t.edges[e].target) != e) {
        if (other && !x.whole && x.s.last[x.t.edges[e].target].holder == e &&
            !injected(Fault::lost_needs_are_overlooked))
          move(x, x.t.edges[e].target);
        continue;
      }
      if (level == nil) {
        in_order = look_ahead_to(x, e, base) && in_order;
        continue;
      }
    }
    asked = true;
    const Level& row = x.t.levels[level];
    std::uint8_t all = marks;
    if (row.optional || row.apart || injected(Fault::members_for_themselves)) {
      all |= mark::alone;
    } else {
      ++together;
      member = e;
    }
    x.s.edge_marks[e] |= all;
    if (row.optional) {
      postpone(x, e);
    } else {
      in_order = look_ahead_to(x, e, base) && in_order;
    }
  }
  if (together == 1) x.s.edge_marks[member] |= mark::alone;
  if (is_stale && source != nil && asked) x.s.run_queue[source].counts = 1;
  if (in_order) return;
  heap_sort({x.s.candidate + base, static_cast<std::size_t>(x.ahead - base)}, [&](Index a, Index b) {
    return compare_siblings(x, {b, false}, {a, false}, true) < 0;
  });
}

/// The next in order, and what it asks for or needs stands ahead.
inline void place(Context& x, Index group) {
  ++x.work;
  if (x.s.last[group].holder != nil) ++x.inherited;
  if (is_followed(x)) {
    leave_to(x, requester_of_holder(x, x.s.now[group]));
    x.top = group;
  }
  Index at = x.placed;
  if (injected(Fault::ancestors_are_equals) && at != 0 &&
      x.s.next_order[x.row.order + at - 1] == requester(x, x.s.now[group].holder)) {
    put(x, x.s.next_order[x.row.order + at - 1], at);
    --at;
  }
  put(x, group, at);
  ++x.placed;
  if (!x.t.groups[group].edges.empty()) look_ahead(x, group);
}

/// The group, and all below it, stand as they stood.
void pass_by(Context& x, Index group) {
  leave_to(x, requester_of_holder(x, x.s.last[group]));
  x.s.group_trail[group] |= trail::passed;
  const Index from = x.s.place[group], count = x.s.extent[group];
  if (from != x.placed) {
    for (Index i = 0; i < count; ++i) put(x, x.s.order[x.row.order + from + i], static_cast<Index>(x.placed + i));
  }
  x.placed = static_cast<Index>(x.placed + count);
  x.inherited = static_cast<Index>(x.inherited + count);
}

inline void visit(Context& x, Index edge, std::uint8_t marks) {
  const Index group = x.t.edges[edge].target;
  if ((marks & mark::tried) == 0 && x.s.request[edge].level != nil) {
    if ((marks & mark::alone) == 0) {
      try_unit(x, edge, (marks & mark::below_stale) != 0);
    } else if (runs_on(x, edge)) {
      x.s.edge_marks[edge] |= mark::visited;
      claim(x, group, edge);
      now_granted(x, edge, x.t.groups[group].providers.begin);
    } else if (stands(x, edge)) {
      const bool was_held = x.s.last[group].holder == edge;
      if ((marks & mark::pushes) != 0 || (was_held && is_opened(x, group))) {
        repeat(x, edge);
      } else if (was_held) {
        x.s.edge_marks[edge] |= mark::visited;
        return pass_by(x, group);
      } else {
        x.s.edge_marks[edge] |= mark::visited | mark::refused;
      }
    } else if ((marks & (mark::below_stale | mark::pushes)) == 0 && taken(x, edge) && !runs_for_now(x, edge)) {
      block_alone(x, edge);
    } else {
      x.s.unit[0] = edge;
      try_alone(x, edge, (marks & mark::below_stale) != 0);
    }
  }
  if (x.s.now[group].holder == edge && is_opened(x, group)) place(x, group);
}

inline void walk_on(Context& x) {
  while (x.ahead != 0) {
    const Index edge = x.s.candidate[--x.ahead];
    visit(x, edge, x.s.edge_marks[edge]);
  }
}

inline void visit_root(Context& x, Index edge) {
  visit(x, edge, static_cast<std::uint8_t>(x.s.edge_marks[edge] | mark::alone));
}

Index first_of_heap(Context& x) {
  const Index first = heap_at(x, 0), moved = heap_at(x, --x.postponed);
  Index at = 0;
  for (;;) {
    auto child = static_cast<Index>(2 * at + 1);
    if (child >= x.postponed) break;
    const auto other = static_cast<Index>(child + 1);
    if (other < x.postponed && goes_first(x, heap_at(x, other), heap_at(x, child))) child = other;
    if (goes_first(x, moved, heap_at(x, child))) break;
    heap_at(x, at) = heap_at(x, child);
    at = child;
  }
  if (x.postponed != 0) heap_at(x, at) = moved;
  return first;
}

void sweep_optional(Context& x, Index root) {
  for (;;) {
    while (root != nil && x.s.request[root].level == nil) root = x.s.next_root[root];
    const bool waits = x.postponed != 0;
    if (root == nil && !waits) return;
    if (root != nil && (!waits || goes_first(x, root, heap_at(x, 0)))) {
      visit_root(x, root);
      root = x.s.next_root[root];
    } else {
      const Index edge = first_of_heap(x);
      visit(x, edge, x.s.edge_marks[edge]);
    }
    walk_on(x);
  }
}

} // namespace

/// Edges of root stay linked in order from pass to pass: few are in another place than before, and mostly none is.
void sort_roots(Context& x) {
  if ((x.s.component[x.component] & work::reordered) == 0) return;
  x.s.component[x.component] &= static_cast<std::uint8_t>(~work::reordered);
  const auto comes_first = [&](Index a, Index b) {
    return compare_siblings(x, a, b) < 0;
  };
  Index* link = &x.s.first_root[x.component];
  Index last = nil, moved = 0;
  for (Index e = *link; e != nil;) {
    const Index following = x.s.next_root[e];
    if (last != nil && comes_first(e, last)) {
      x.s.candidate[moved++] = e;
    } else {
      *link = e;
      link = &x.s.next_root[e];
      last = e;
    }
    e = following;
  }
  *link = nil;
  heap_sort({x.s.candidate, moved}, comes_first);
  link = &x.s.first_root[x.component];
  for (Index i = 0; i < moved; ++i) {
    const Index e = x.s.candidate[i];
    while (*link != nil && comes_first(*link, e)) link = &x.s.next_root[*link];
    x.s.next_root[e] = *link;
    *link = e;
    link = &x.s.next_root[e];
  }
}

/// Tries candidates, the first in order first, until none is left, and puts down who is claimed in the order in which
/// the edges stand. Below a mandatory edge that order is the tree's: an edge, all that is below it, its next sibling.
/// What is optional waits in a heap until all else was tried.
void sweep(Context& x) {
  Index root = x.s.first_root[x.component];
  for (; root != nil && !optional(x, root); root = x.s.next_root[root]) {
    if (x.s.request[root].level == nil) continue;
    visit_root(x, root);
    walk_on(x);
  }
  if (root != nil || x.postponed != 0) sweep_optional(x, root);
}

/// What is in limbo, after all else.
void sweep_below(Context& x, Index group) {
  place(x, group);
  walk_on(x);
  sweep_optional(x, nil);
}

/// What is placed next is below this group, nil being root: of what was placed and does not lie above, all is placed.
void leave_to(Context& x, Index group) {
  while (x.top != group && x.top != nil) {
    x.s.extent[x.top] = static_cast<Index>(x.placed - x.s.place[x.top]);
    x.top = requester_of_holder(x, x.s.now[x.top]);
  }
}

} // namespace director::arbitration
