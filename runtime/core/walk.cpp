// Door: runtime/core/arbitration.hpp. Test: tests/runtime/core/arbitration_test.cpp.
//
// Who is tried next: a walk along the order of edges.
#include "runtime/core/arbitration.hpp"
#include "runtime/core/heap_sort.hpp"
#include "runtime/core/marks.hpp"
#include "runtime/core/planted.hpp"

namespace director {

/// Edges of root stay linked in order from pass to pass: few are in another place than before, and mostly none is.
void Pass::sort_roots() {
  if ((s_.component[component_] & work::reordered) == 0) return;
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
    if (s_.request[root] != nil) visit(root), walk_on();
  }
  sweep_optional(root);
}

void Pass::sweep_optional(Index root) {
  for (;;) {
    while (root != nil && s_.request[root] == nil) root = s_.next_root[root];
    const bool waits = postponed_ != 0;
    if (root == nil && !waits) return;
    if (root != nil && (!waits || goes_first(root, heap_at(0)))) {
      visit(root);
      root = s_.next_root[root];
    } else {
      visit(first_of_heap());
    }
    walk_on();
  }
}

void Pass::walk_on() {
  while (ahead_ != 0) visit(s_.candidate[--ahead_]);
}

inline void Pass::visit(Index edge) {
  if ((s_.edge_marks[edge] & mark::tried) == 0 && s_.request[edge] != nil && may_ask(requester(edge))) try_edge(edge);
  const Index group = t_.edges[edge].target;
  if (s_.now[group].holder == edge) place(group);
}

/// The next in order, and what it asks for or needs stands ahead.
void Pass::place(Index group) {
  s_.next_order[c_.order + placed_++] = group;
  if (!t_.groups[group].edges.empty()) look_ahead(group);
}

void Pass::look_ahead(Index group) {
  const Range edges = t_.groups[group].edges;
  const bool asks = may_ask(group);
  const Index base = ahead_;
  bool in_order = true;
  for (Index e = edges.end; e != edges.begin;) {
    --e;
    const Index level = s_.request[e];
    if ((level == nil || !asks) && s_.now[t_.edges[e].target].holder != e) continue;
    if (level != nil && t_.levels[level].optional) {
      postpone(e);
      continue;
    }
    if (ahead_ != base) in_order = in_order && compare_siblings({e, false}, {s_.candidate[ahead_ - 1], false}, true) < 0;
    s_.candidate[ahead_++] = e;
  }
  if (in_order) return;
  heap_sort({s_.candidate + base, static_cast<std::size_t>(ahead_ - base)},
            [&](Index a, Index b) { return compare_siblings({b, false}, {a, false}, true) < 0; });
}

/// The members of a unit, in order: they stand ahead, behind its first one. Returns how many it has.
Index Pass::join_siblings(Index first) {
  Index count = 1;
  const Index from = requester(first);
  for (Index i = ahead_; i > 0; --i) {
    const Index e = s_.candidate[i - 1];
    if (requester(e) != from) break;
    if (s_.request[e] == nil || alone(e)) continue;
    s_.edge_marks[e] |= mark::tried;
    s_.unit[count++] = e;
  }
  return count;
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
