// docs/semantics.md, section 4.4: the pass.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/pass.hpp"

#include "runtime/core/arbitration/availability.hpp"
#include "runtime/core/arbitration/grant.hpp"
#include "runtime/core/arbitration/push.hpp"
#include "runtime/core/arbitration/staleness.hpp"
#include "runtime/core/arbitration/trail.hpp"
#include "runtime/core/arbitration/walk.hpp"

namespace director::arbitration {

namespace {

void begin_sweep(Context& x) {
  x.ahead = x.postponed = x.placed = x.inherited = x.denied_count = 0;
  x.stale_granted = x.stale_kept;
  x.first_moved = x.top = nil;
  x.lineage_is_valid = is_followed(x) || x.had_pushes || x.row.compared;
  x.pushing = false;
}

/// From the beginning, but for which denials are forgotten.
void sweep_again(Context& x) {
  clear_marks(x);
  mark_pushers(x);
  for (const Index g : opened(x)) {
    x.s.group_marks[g] &= mark::forgotten | mark::listed;
    clear(x, g);
  }
  const Index* const order = x.s.order + x.row.order;
  for (Index i = 0; i < x.s.order_count[x.component]; ++i) {
    x.s.place[order[i]] = i;
    x.s.next_order[x.row.order + i] = order[i];
  }
  begin_sweep(x);
}

void keep_in_limbo(Context& x, Index group) {
  const Index end = entries_of(x, group, x.s.last);
  for (Index i = 0; i < end; ++i) {
    if (x.s.now[x.s.entry_group[i]].holder != nil) return;
  }
  x.depends_on_last = x.depends_on_stale = true;
  x.lineage_is_valid = false;
  claim(x, group, static_cast<Index>(x.t.edges.size() + group));
  x.s.now[group].active = x.s.last[group].active;
  if (x.s.last[group].planned != nil) plan_for(x, group, x.s.last[group].planned, 0, end);
  for (Index i = 0; i < end; ++i) claim(x, x.s.entry_group[i], x.s.entry_need[i]);
  claim_plan(x, 0, end);
  compare_claim(x, group);
  for (Index i = 0; i < end; ++i) compare_claim(x, x.s.entry_group[i]);
  sweep_below(x, group);
}

/// Hand-over: live groups that nobody claims are kept for an heir that is about to run.
void keep_for_heirs(Context& x) {
  if (x.stale_granted == 0 || injected(Fault::nobody_inherits)) return;
  for (Index i = 0; i < x.s.order_count[x.component]; ++i) {
    const Index group = x.s.order[x.row.order + i];
    if (x.s.last[group].active == nil || x.s.now[group].holder != nil) continue;
    x.s.reach[0] = group;
    if (reached_from_stale(x, 1, nil)) keep_in_limbo(x, group);
  }
  const std::span<Index> limbo{x.s.next_order + x.row.order + x.limbo_begin,
                               static_cast<std::size_t>(x.placed - x.limbo_begin)};
  sort_by_holders(x, limbo, Chains::current); // by declaration
  for (Index at = x.limbo_begin; at < x.placed; ++at) put(x, limbo[at - x.limbo_begin], at);
}

/// What follows from the claims: who stays live for a need, which pushes are left and in force, and the order.
void finish(Context& x) {
  leave_to(x, nil);
  for (const Index g : opened(x)) {
    if (x.s.now[g].holder == nil || x.s.now[g].active != nil || x.s.last[g].active == nil) continue;
    x.depends_on_last = x.depends_on_stale = true;
    if (stale(x, g) || injected(Fault::unwanted_needs_live_on)) x.s.now[g].active = x.s.last[g].active;
  }
  x.s.next_count[x.component] = x.placed;
  x.s.first_moved[x.component] = x.first_moved;
  if (x.pushing) finish_pushes(x);
}

} // namespace

void decide(Context& x, Index component) {
  x.row = x.t.components[component];
  x.component = component;
  x.had_pushes = x.s.pushed_count[component] != 0;
  begin_trail(x);
  x.had_pushes = x.pushed_count != 0;
  x.depends_on_stale = false;
  x.depends_on_last = x.had_pushes || x.s.on_last[component] != 0;
  sort_roots(x);
  for (begin_sweep(x);; sweep_again(x)) {
    sweep(x);
    if (x.denied_count == 0 || !denied_in_vain(x)) break;
  }
  x.walking = false;
  x.limbo_begin = x.placed;
  if (x.stale_granted != 0 && x.inherited != x.s.order_count[component]) keep_for_heirs(x);
  finish(x);
  x.lineage_is_valid = false; // from here on it may be about several components
}

/// The next pass over each component begins from nothing: the last assignment is not that of its last pass.
void forget_trail(Context& x) {
  for (Index c = 0; c < x.t.components.size(); ++c) x.s.news_count[c] = nil;
  for (Index g = 0; g < x.t.groups.size(); ++g) x.s.now[g] = x.s.last[g];
  for (Index slot = 0; slot < x.t.plan_groups.size(); ++slot) x.s.now.plan[slot] = x.s.last.plan[slot];
}

} // namespace director::arbitration
