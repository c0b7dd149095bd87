// Door: runtime/core/arbitration.hpp. Test: tests/runtime/core/arbitration_test.cpp.
// SPDX-License-Identifier: MIT
//
// Section 4.4: the pass, and whose orders are outdated in it.
#include "runtime/core/arbitration.hpp"
#include "runtime/core/marks.hpp"
#include "runtime/core/planted.hpp"

namespace director {

void Pass::decide(Index component) {
  c_ = t_.components[component];
  component_ = component;
  equals_ = (s_.component_traits[component] & trait::equals) != 0;
  depends_on_stale_ = limbo_ = false;
  pushed_count_ = disturbed_count_ = 0;
  whole_ = s_.known[component] == 0;
  for (const Index g : t_.list(c_.groups)) {
    s_.group_marks[g] = 0;
    s_.turn[g].counts = 0;
    if (s_.last[g].push.edge != nil) list_push(g);
    if ((s_.group_trail[g] & trail::news) != 0) s_.disturbed[disturbed_count_++] = g;
    s_.now[g] = Standing{};
  }
  pushed_ = pushed_count_ != 0;
  depends_on_last_ = pushed_;
  sort_roots();
  clear();
  for (begin_trail();; clear()) {
    sweep();
    if (denied_ == 0 || !denied_in_vain()) break;
    for (const Index g : t_.list(c_.groups)) {
      s_.group_marks[g] &= mark::forgotten | mark::listed;
      s_.now[g] = Standing{};
    }
  }
  if (stale_granted_ != 0 && inherited_ != s_.order_count[component]) hand_over();
  finish();
  end_trail();
  measured_ = false; // from here on it may be about several components
}

void Pass::clear() {
  ahead_ = postponed_ = placed_ = inherited_ = denied_ = stale_granted_ = 0;
  measured_ = pushed_ || (s_.component_traits[component_] & trait::compared) != 0;
  pushing_ = needs_ = false;
  for (const Index g : alternatives(component_) ? t_.list(c_.groups) : std::span<const Index>{}) {
    const Range slots = t_.groups[g].slots;
    for (Index slot = slots.begin; slot != slots.end; ++slot) s_.now.plan[slot] = nil;
  }
  for (const Index e : t_.list(c_.edges)) s_.edge_marks[e] = 0;
  for (const Index g : pushed_groups()) {
    const Index pusher = s_.last[g].push.edge;
    if (pusher != nil) s_.edge_marks[pusher] |= mark::pushes;
  }
}

/// 4.2: the first holder for whose sake a group was denied that does not claim it in the end is forgotten.
bool Pass::denied_in_vain() {
  for (Index i = 0; i < denied_; ++i) {
    const Index group = s_.denied[i];
    if (s_.now[group].holder == s_.last[group].holder || planted(Fault::denials_are_final)) continue;
    s_.group_marks[group] |= mark::forgotten;
    reach(group);
    return true;
  }
  return false;
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

/// Something new among the members in hand, whose requester's orders are outdated.
bool Pass::any_new(Index count) const {
  for (Index at = 0; at < count; ++at) {
    if (!runs_for_now(s_.member[at])) return true;
  }
  return false;
}

} // namespace director
