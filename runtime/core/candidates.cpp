// Door: runtime/core/arbitration.hpp. Test: tests/runtime/core/arbitration_test.cpp.
//
// Who is tried next: the candidates of a pass, in order.
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

/// Candidates are the edges of root, in order, a heap, and beside it the one that was put last: below what was just
/// granted the order mostly goes on.
void Pass::push_candidate(Index edge) {
  s_.edge_marks[edge] |= mark::candidate;
  if (next_ == nil) {
    next_ = edge;
    return;
  }
  if (goes_first(edge, next_)) {
    const Index later = next_;
    next_ = edge;
    edge = later;
  }
  Index at = candidates_++;
  while (at > 0) {
    const auto parent = static_cast<Index>((at - 1) / 2);
    if (!goes_first(edge, s_.candidate[parent])) break;
    s_.candidate[at] = s_.candidate[parent];
    at = parent;
  }
  s_.candidate[at] = edge;
}

void Pass::add_candidates(Index group) {
  again_ = 0;
  candidates_of(group);
  for (Index i = 0; i < again_; ++i) candidates_of(s_.reach[i]);
}

/// Edges that are one unit are looked for together, from the first of them: the others do not stand in the heap. Where
/// nobody can say a word against it, they are granted before their turn.
void Pass::candidates_of(Index group) {
  const Range edges = t_.groups[group].edges;
  Index first = nil;
  bool there = false; // one of them is a candidate already
  bool certain = true;
  for (Index e = edges.begin; e != edges.end; ++e) {
    if (s_.request[e] == nil || (s_.edge_marks[e] & mark::tried) != 0) continue;
    const bool is_certain = stays_granted(e);
    if ((s_.edge_marks[e] & mark::candidate) != 0) {
      there = there || !alone(e);
    } else if (!alone(e)) {
      s_.edge_marks[e] |= mark::candidate;
      certain = certain && is_certain;
      if (first == nil || compare_siblings({e, false}, {first, false}, true) < 0) first = e;
    } else if (is_certain) {
      grant_again(e);
    } else {
      push_candidate(e);
    }
  }
  if (first == nil || there) return;
  if (!certain) return push_candidate(first);
  for (Index e = edges.begin; e != edges.end; ++e) {
    if ((s_.edge_marks[e] & mark::candidate) != 0 && !alone(e)) grant_again(e);
  }
}

/// It was granted, there is one way to grant it, which has no conditions, and nobody else ever asks for its target or
/// pushes it: so it will be granted, and nobody's decision depends on when.
bool Pass::stays_granted(Index edge) const {
  const Index group = t_.edges[edge].target;
  return (s_.traits[group] & trait::certain) != 0 && runs_for_now(edge) &&
         s_.enabled[t_.groups[group].providers.begin] != 0;
}

void Pass::grant_again(Index edge) {
  const Index group = t_.edges[edge].target;
  s_.edge_marks[edge] = static_cast<std::uint8_t>((s_.edge_marks[edge] & ~mark::candidate) | mark::tried);
  in_turn_ = false;
  claim(group, edge);
  now_granted(edge, t_.groups[group].providers.begin);
  s_.reach[again_++] = group;
}

/// Its requester may not ask for anything; nor for what is one unit with it.
void Pass::drop_candidates(Index edge) {
  const auto drop = [&](Index e) { s_.edge_marks[e] &= static_cast<std::uint8_t>(~mark::candidate); };
  drop(edge);
  if (alone(edge)) return;
  const Range siblings = t_.groups[requester(edge)].edges;
  for (Index e = siblings.begin; e != siblings.end; ++e) {
    if ((s_.edge_marks[e] & mark::candidate) != 0 && !alone(e)) drop(e);
  }
}

/// Takes the first in order away; nil: there is none.
Index Pass::first_candidate() {
  while (root_ != nil && !requested(root_)) root_ = s_.next_root[root_];
  Index first = root_;
  if (next_ != nil && (first == nil || goes_first(next_, first))) first = next_;
  if (candidates_ != 0 && (first == nil || goes_first(s_.candidate[0], first))) return first_of_heap();
  if (first == root_) {
    if (root_ != nil) root_ = s_.next_root[root_];
  } else {
    next_ = nil;
  }
  return first;
}

Index Pass::first_of_heap() {
  const Index first = s_.candidate[0], moved = s_.candidate[--candidates_];
  Index at = 0;
  for (;;) {
    auto child = static_cast<Index>(2 * at + 1);
    if (child >= candidates_) break;
    const auto other = static_cast<Index>(child + 1);
    if (other < candidates_ && goes_first(s_.candidate[other], s_.candidate[child])) child = other;
    if (goes_first(moved, s_.candidate[child])) break;
    s_.candidate[at] = s_.candidate[child];
    at = child;
  }
  if (candidates_ != 0) s_.candidate[at] = moved;
  return first;
}

} // namespace director
