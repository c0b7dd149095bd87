// docs/semantics.md, section 4.4: the candidate that is tried next.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/grant.hpp"
#include "runtime/core/arbitration/pass.hpp"
#include "runtime/core/arbitration/push.hpp"

namespace director::arbitration {

namespace {

/// Whether the edge is granted again without a search: the only provider of its free target has no conditions or needs.
inline bool is_granted_again(const Context& x, Index edge) {
  const Index group = x.t.edges[edge].target;
  return is_opened(x, group) && x.t.groups[group].simple && !x.t.groups[group].conditional && was_granted(x, edge) &&
         !taken(x, edge) && !x.s.edge_marks[edge].has(mark::pushes) &&
         x.s.enabled[x.t.groups[group].providers.begin] != 0;
}

/// Puts the group next in the new order; its requests and needs come next in the walk.
inline void place(Context& x, Index group) {
  ++x.work;
  if (x.s.last[group].holder != nil) ++x.inherited;
  if (is_followed(x)) {
    close_extents(x, requester_of_holder(x, x.s.now[group]));
    x.top = group;
  }
  put(x, group, x.placed++);
  if (!x.t.groups[group].edges.empty()) add_candidates(x, group);
}

DIRECTOR_INLINE void visit(Context& x, Index edge) {
  const Index group = x.t.edges[edge].target;
  const std::uint8_t marks = x.s.edge_marks[edge];
  if ((marks & mark::optional) != 0) return postpone(x, edge);
  if ((marks & mark::tried) == 0 && x.s.request[edge].level != nil) {
    if ((marks & mark::alone) == 0) {
      try_unit(x, edge, (marks & mark::below_stale) != 0);
    } else if (is_granted_again(x, edge)) {
      x.s.edge_marks[edge] |= mark::visited;
      grant_target(x, edge, x.t.groups[group].providers.begin);
    } else if (stands(x, edge)) {
      const bool was_held = x.s.last[group].holder == edge;
      if (was_held && x.line_count != 0 && !is_opened(x, group)) check_lines(x, group);
      if (was_held && is_opened(x, group)) {
        claim_again(x, edge);
      } else if (was_held) {
        x.s.edge_marks[edge] |= mark::visited;
        return pass_by(x, group);
      } else {
        x.s.edge_marks[edge] |= mark::visited | mark::refused;
      }
    } else if ((marks & (mark::below_stale | mark::pushes)) == 0 && taken(x, edge) && !was_granted(x, edge)) {
      // It held nothing, and its target is claimed: its decision depends on nothing else.
      x.s.edge_marks[edge] |= mark::visited | mark::refused;
      x.s.queued[edge] = {Why::blocked, nil};
      if (is_followed(x)) note_dependence(x, edge, trail::in_line);
    } else {
      x.s.unit[0] = edge;
      begin_decision(x, 1);
      decide_alone(x, edge, (marks & mark::below_stale) != 0);
      end_decision(x, 1);
    }
  }
  if (x.s.now[group].holder == edge && is_opened(x, group)) place(x, group);
}

} // namespace

/// Visits the candidates on the stack, and those that they add.
void walk(Context& x) {
  while (x.ahead != 0) visit(x, x.s.candidate[--x.ahead]);
}

void walk_from(Context& x, Index edge) {
  x.s.candidate[x.ahead++] = edge;
  walk(x);
}

void walk_from_root(Context& x, Index edge) {
  x.s.edge_marks[edge] |= mark::alone;
  walk_from(x, edge);
}

/// Tries candidates in order until none is left, and puts the claimed groups into the new order. Below a mandatory edge
/// this is an edge, all below it, its next sibling. Optional candidates wait until all others were tried.
void sweep(Context& x) {
  Index root = x.s.first_root[x.component];
  for (; root != nil && !optional(x, root); root = x.s.next_root[root]) {
    if (x.s.request[root].level == nil) continue;
    if (!x.whole && x.undecided == nil && copy_unchanged_rest(x, root)) return;
    walk_from_root(x, root);
    if (x.undecided == root) x.undecided = nil;
  }
  if (root != nil || x.postponed != 0) sweep_optional(x, root);
}

/// Tries the candidates below a group in limbo, after all others.
void sweep_below(Context& x, Index group) {
  place(x, group);
  walk(x);
  if (x.postponed != 0) sweep_optional(x, nil);
}

} // namespace director::arbitration
