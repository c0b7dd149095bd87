// docs/semantics.md, section 4.4, Limbo: unclaimed groups that are kept for a stale group that may still request them.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/grant.hpp"
#include "runtime/core/arbitration/pass.hpp"

const char director::part::limbo = 0;

namespace director::arbitration {

namespace {

void keep_in_limbo(Context& x, Index group) {
  const Index end = entries_of(x, group, x.s.last);
  for (Index i = 0; i < end; ++i) {
    if (x.s.now[x.s.entry[i].group].holder != nil) return;
  }
  x.depends_on_last = true;
  claim(x, group, static_cast<Index>(x.t.edges.size() + group));
  x.s.now[group].active = x.s.last[group].active;
  claim_plan(x, group, x.s.last[group].planned, 0, end);
  compare_claim(x, group);
  for (Index i = 0; i < end; ++i) compare_claim(x, x.s.entry[i].group);
  sweep_below(x, group);
}

/// A group that was in limbo is ordered by declaration from now on. So what is below it, and is queued or has several
/// choices, may find other groups claimed than in the last pass.
void reach_below_limbo(Context& x) {
  for (Index i = x.s.order_count[x.component]; i-- != 0;) { // limbo is last in the order
    const Index group = x.s.order[x.row.order + i];
    if (!was_in_limbo(x, group)) return;
    if (x.s.now[group].holder != nil) continue;
    for (const Index e : x.t.groups[group].edges.rows()) {
      if (x.s.queued[e].why != Why::none || !x.t.groups[target(x, e)].simple) reach_edge(x, e);
    }
  }
}

} // namespace

/// Keeps each unclaimed live group that a granted stale group may still request.
void keep_unclaimed(Context& x) {
  if (!x.whole && x.had_limbo) reach_below_limbo(x);
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

} // namespace director::arbitration
