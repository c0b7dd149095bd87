// docs/semantics.md, section 4.3: the plan that a group has, and the entries of the combination in hand.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/choices.hpp"
#include "runtime/core/arbitration/grant.hpp"
#include "runtime/core/arbitration/order.hpp"

namespace director::arbitration {

/// Where the plan of `owner` keeps the provider picked for `group`; nil where it has only one.
Index slot_of(const Context& x, Index owner, Index group) {
  const Range slots = x.t.groups[owner].slots;
  for (Index slot = slots.begin; slot != slots.end; ++slot) {
    if (x.t.plan_groups[slot] == group) return slot;
  }
  return nil;
}

void drop_entries(Context& x, Index begin, Index end) {
  for (Index i = end; i-- > begin;) x.s.trial[x.s.entry[i].group] = nil;
}

namespace {

/// The plan of `owner` for its provider is entries [begin, end).
void plan_for(Context& x, Index owner, Index provider, Index begin, Index end) {
  const Range slots = x.t.groups[owner].slots;
  x.s.now[owner].planned = provider;
  for (Index slot = slots.begin; slot != slots.end; ++slot) x.s.now.plan[slot] = nil;
  if (slots.empty()) return;
  for (Index i = begin; i < end; ++i) {
    const Index slot = slot_of(x, owner, x.s.entry[i].group);
    if (slot != nil) x.s.now.plan[slot] = x.s.entry[i].provider;
  }
}

} // namespace

/// The plan of `owner`, as plan_for. Every group of it is claimed and needed from now on; one that is not granted has
/// the part of the plan that it needs.
void claim_plan(Context& x, Index owner, Index provider, Index begin, Index end) {
  plan_for(x, owner, provider, begin, end);
  for (Index i = begin; i < end; ++i) {
    const Index group = x.s.entry[i].group;
    claim(x, group, x.s.entry[i].need);
    x.s.now[group].flags |= flag::needed;
    if ((x.s.now[group].flags & flag::granted) != 0) continue;
    auto below = static_cast<Index>(i + 1); // depth first: what an entry needs stands right behind it
    while (below < end && x.s.entry[below].parent != nil && x.s.entry[below].parent >= i) ++below;
    plan_for(x, group, x.s.entry[i].provider, static_cast<Index>(i + 1), below);
  }
}

/// Writes the plan that a group has as entries from 0 on; returns how many.
Index entries_of(Context& x, Index group, const Assignment& of) {
  const Index planned = of[group].planned;
  if (planned == nil) return 0;
  Index end = 0;
  for (Index parent = nil;;) {
    Index place = 0;
    Index owner = parent;
    Index needer = parent == nil ? planned : x.s.entry[parent].provider;
    while (place >= x.t.providers[needer].needs.size()) { // the next need, depth first
      if (owner == nil) return end;
      place = static_cast<Index>(x.s.entry[owner].place + 1);
      owner = x.s.entry[owner].parent;
      needer = owner == nil ? planned : x.s.entry[owner].provider;
    }
    const Index need = x.t.list(x.t.providers[needer].needs)[place], needed = x.t.edges[need].target;
    const Index slot = slot_of(x, group, needed);
    x.s.entry[end].group = needed;
    x.s.entry[end].need = need;
    x.s.entry[end].provider = slot == nil ? x.t.groups[needed].providers.begin : of.plan[slot];
    x.s.entry[end].parent = owner;
    x.s.entry[end].place = place;
    parent = end++;
  }
}

} // namespace director::arbitration
