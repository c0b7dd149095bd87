// Door: runtime/core/arbitration/arbitration.hpp. Test: tests/runtime/core/arbitration/arbitration_test.cpp.
// SPDX-License-Identifier: MIT
//
// Section 4.4, Hand-over, when no candidate is left; and what follows from the claims when the pass ends.

#include "runtime/core/arbitration/arbitration.hpp"
#include "runtime/core/base/fault_injection.hpp"

namespace director {

/// Live groups that nobody claims are kept for an heir that is about to run.
void Pass::hand_over() {
  if (stale_granted_ == 0 || injected(Fault::nobody_inherits)) return;
  for (Index i = 0; i < s_.order_count[component_]; ++i) {
    const Index group = s_.order[c_.order + i];
    if (s_.last[group].active == nil || s_.now[group].holder != nil) continue;
    s_.reach[0] = group;
    if (reached_from_stale(1, nil)) hand_over(group);
  }
  const std::span<Index> limbo{s_.next_order + c_.order + limbo_, static_cast<std::size_t>(placed_ - limbo_)};
  sort(limbo, Chains::current); // by declaration
  for (Index at = limbo_; at < placed_; ++at) put(limbo[at - limbo_], at);
}

void Pass::hand_over(Index group) {
  const Index end = entries_of(group, s_.last);
  for (Index i = 0; i < end; ++i) {
    if (s_.now[s_.entry_group[i]].holder != nil) return;
  }
  depends_on_last_ = depends_on_stale_ = true;
  lineage_is_valid_ = false;
  claim(group, static_cast<Index>(t_.edges.size() + group));
  s_.now[group].active = s_.last[group].active;
  if (s_.last[group].planned != nil) plan_for(group, s_.last[group].planned, 0, end);
  for (Index i = 0; i < end; ++i) claim(s_.entry_group[i], s_.entry_need[i]);
  claim_plan(0, end);
  compare_claim(group);
  for (Index i = 0; i < end; ++i) compare_claim(s_.entry_group[i]);
  sweep_below(group);
}

/// Writes the plan that a group has as entries from 0 on; returns how many.
Index Pass::entries_of(Index group, const Assignment& of) {
  const Index planned = of[group].planned;
  if (planned == nil) return 0;
  Index end = 0;
  for (Index parent = nil;;) {
    Index place = 0;
    Index owner = parent;
    Index needer = parent == nil ? planned : s_.entry_provider[parent];
    while (place >= t_.providers[needer].needs.size()) { // the next need, depth first
      if (owner == nil) return end;
      place = static_cast<Index>(s_.entry_place[owner] + 1);
      owner = s_.entry_parent[owner];
      needer = owner == nil ? planned : s_.entry_provider[owner];
    }
    const Index need = t_.list(t_.providers[needer].needs)[place], needed = t_.edges[need].target;
    const Index slot = slot_of(group, needed);
    s_.entry_group[end] = needed;
    s_.entry_need[end] = need;
    s_.entry_provider[end] = slot == nil ? t_.groups[needed].providers.begin : of.plan[slot];
    s_.entry_parent[end] = owner;
    s_.entry_place[end] = place;
    parent = end++;
  }
}

/// What follows from the claims: who stays live for a need, which pushes are left and in force, and the order.
void Pass::finish() {
  leave_to(nil);
  for (const Index g : opened()) {
    if (s_.now[g].holder == nil || s_.now[g].active != nil || s_.last[g].active == nil) continue;
    depends_on_last_ = depends_on_stale_ = true;
    if (stale(g) || injected(Fault::unwanted_needs_live_on)) s_.now[g].active = s_.last[g].active;
  }
  s_.next_count[component_] = placed_;
  s_.first_moved[component_] = first_moved_;
  if (pushing_) finish_pushes();
}

void Pass::finish_pushes() {
  for (const Index g : pushed_groups()) {
    Push& push = s_.now[g].push;
    if (push.edge == nil) continue;
    depends_on_last_ = true;
    if (s_.now[g].holder == nil) {
      if (asked_for(g) || injected(Fault::pushes_outlive_requests)) continue;
      s_.edge_trail[push.edge] |= trail::on_stale; // whoever makes it again has to be asked again
      push = Push{};
      continue;
    }
    const bool was_in_force = (s_.last[g].flags & flag::in_force) != 0;
    if (s_.now[g].active != push.provider || (!s_.now[g].granted() && !was_in_force) ||
        !applies(push, s_.now[g].holder))
      continue;
    s_.now[g].flags |= flag::in_force;
    if (!holds(push.condition)) s_.now[g].flags |= flag::serving;
  }
}

/// By root or a live group.
bool Pass::asked_for(Index group) const {
  for (const Index edge : t_.list(t_.groups[group].requesters)) {
    const Index from = t_.edges[edge].requester;
    if (requested(edge) && (from == nil || s_.now[from].active != nil)) return true;
  }
  return false;
}

} // namespace director
