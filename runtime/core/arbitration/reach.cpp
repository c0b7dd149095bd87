// Door: runtime/core/arbitration/arbitration.hpp. Test: tests/runtime/core/arbitration/trail_test.cpp.
// SPDX-License-Identifier: MIT
//
// From something that is another than in the last pass to the units that it reaches, which are decided again: an input,
// or a group whose claim, plan, push or place in the order is another one.

#include "runtime/core/arbitration/arbitration.hpp"
#include "runtime/core/base/marks.hpp"
#include "runtime/core/base/fault_injection.hpp"

namespace director {

/// Its unit is decided again.
void Pass::reach_edge(Index edge) {
  if (whole_ || (s_.edge_trail[edge] & trail::reached) != 0) return;
  s_.edge_trail[edge] |= trail::reached;
  s_.reached[reached_count_++] = edge;
  if (requester(edge) != nil) open(requester(edge));
}

/// Units that may look at the group. Who is not held has none, and when it gets hold of something, all of its own are
/// decided anyway.
template <class Visit>
void Pass::each_user_edge(Index group, Visit&& visit) {
  for (const Index user : t_.list(t_.groups[group].users)) {
    if (user != group && injected(Fault::who_uses_it_is_overlooked)) continue;
    for (const Index e : t_.list(t_.groups[user].requesters)) {
      const Index from = t_.edges[e].requester;
      if (s_.request[e].level != nil && (from == nil || s_.last[from].holder != nil)) visit(e);
    }
  }
  const Index pusher = s_.last[group].push.edge;
  if (pusher != nil) reach_edge(pusher);
}

/// The edge is requested at another level than before, or not any more; and with it its unit has another member.
void Pass::take_up(Index edge, bool with_siblings) {
  const Index group = target(edge), from = requester(edge);
  reach_edge(edge);
  const Range edges = from == nil || !with_siblings ? Range{} : t_.groups[from].edges;
  for (Index e = edges.begin; e != edges.end && !injected(Fault::other_members_are_overlooked); ++e) reach_edge(e);
  reach(group);
  reach_pushes_of(edge);
  if (s_.last[group].holder == edge) move(group);
}

/// The last pass changed where the group stands. Who looks at the last result looks at another one now.
void Pass::take_up_last(Index group) {
  disturb();
  if (injected(Fault::the_last_result_is_overlooked)) return;
  each_user_edge(group, [&](Index e) {
    if (pushed_ || (s_.edge_trail[e] & trail::on_last) != 0) reach_edge(e);
  });
}

/// Who may look at the group is decided again.
void Pass::reach(Index group) {
  if (whole_ || (s_.group_trail[group] & trail::disturbed) != 0) return;
  s_.group_trail[group] |= trail::disturbed;
  disturb();
  open(group);
  each_user_edge(group, [&](Index e) { reach_edge(e); });
}

/// What holds the group, or where that stands in the order, is another: so are the places of all below it.
void Pass::move(Index group) {
  Index found = 0;
  const auto add = [&](Index g) {
    reach(g);
    if ((s_.group_trail[g] & trail::moved) != 0) return;
    s_.group_trail[g] |= trail::moved;
    s_.reach[found++] = g;
  };
  add(group);
  for (Index i = 0; i < found && !injected(Fault::what_is_below_is_overlooked); ++i) {
    const Range edges = t_.groups[s_.reach[i]].edges;
    for (Index e = edges.begin; e != edges.end; ++e) {
      reach_edge(e);
      reach_pushes_of(e);
      if (s_.last[t_.edges[e].target].holder == e) add(t_.edges[e].target);
    }
  }
}

void Pass::reach_pushes_of(Index edge) {
  if ((s_.edge_marks[edge] & mark::pushes) == 0) return;
  for (const Index g : pushed_groups()) {
    if (s_.last[g].push.edge == edge) reach(g);
  }
}

} // namespace director
