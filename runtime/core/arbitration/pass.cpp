// Door: runtime/core/arbitration/arbitration.hpp. Test: tests/runtime/core/arbitration/arbitration_test.cpp.
// SPDX-License-Identifier: MIT
//
// Section 4.4: the pass, and whose orders are outdated in it.
#include "runtime/core/arbitration/arbitration.hpp"
#include "runtime/core/base/marks.hpp"
#include "runtime/core/base/fault_injection.hpp"

namespace director {

void Pass::decide(Index component) {
  c_ = t_.components[component];
  component_ = component;
  equals_ = (s_.component_traits[component] & trait::equals) != 0;
  pushed_ = s_.pushed_count[component] != 0;
  begin_trail();
  pushed_ = pushed_count_ != 0;
  depends_on_stale_ = false;
  depends_on_last_ = pushed_ || s_.on_last[component] != 0;
  sort_roots();
  for (begin_sweep();; sweep_again()) {
    sweep();
    if (denied_ == 0 || !denied_in_vain()) break;
  }
  walking_ = false;
  limbo_ = placed_;
  if (stale_granted_ != 0 && inherited_ != s_.order_count[component]) hand_over();
  finish();
  lineage_is_valid_ = false; // from here on it may be about several components
}

void Pass::begin_sweep() {
  ahead_ = postponed_ = placed_ = inherited_ = denied_ = 0;
  stale_granted_ = stale_kept_;
  first_moved_ = top_ = nil;
  lineage_is_valid_ = is_followed() || pushed_ || (s_.component_traits[component_] & trait::compared) != 0;
  pushing_ = false;
}

/// From the beginning, but for which denials are forgotten.
void Pass::sweep_again() {
  clear_marks();
  mark_pushers();
  for (const Index g : opened()) {
    s_.group_marks[g] &= mark::forgotten | mark::listed;
    clear(g);
  }
  const Index* const order = s_.order + c_.order;
  for (Index i = 0; i < s_.order_count[component_]; ++i) {
    s_.place[order[i]] = i;
    s_.next_order[c_.order + i] = order[i];
  }
  begin_sweep();
}

/// 4.2: the first holder for whose sake a group was denied that does not claim it in the end is forgotten.
bool Pass::denied_in_vain() {
  for (Index i = 0; i < denied_; ++i) {
    const Index group = s_.denied[i];
    if (s_.now[group].holder == s_.last[group].holder || injected(Fault::denials_are_final)) continue;
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
    const GroupAssignment& now = s_.now[group];
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
