// docs/semantics.md, section 4.4: the pass.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/pass.hpp"

#include "runtime/core/arbitration/push.hpp"
#include "runtime/core/arbitration/trail.hpp"

namespace director::arbitration {

namespace {

void begin_sweep(Context& x) {
  x.ahead = x.postponed = x.placed = x.inherited = x.denied_count = 0;
  x.stale_granted = x.unopened_count;
  x.first_moved = x.top = x.rest = x.undecided = nil;
}

/// Keeps the last result.
void keep_all(Context& x) {
  x.walking = false;
  x.rest = x.s.first_root[x.component];
  x.limbo_begin = x.placed = x.s.order_count[x.component];
}

void sweep_all(Context& x) {
  for (;; begin_sweep(x)) {
    sweep(x);
    if (x.denied_count == 0 || !denied_in_vain(x)) break;
  }
  x.walking = false;
  x.limbo_begin = x.placed;
  if (x.stale_granted != 0 && x.inherited != x.s.order_count[x.component]) keep_unclaimed(x);
}

/// Derives from the claims which groups stay live as needs, which pushes remain and are in force, and the order.
void finish(Context& x) {
  if (is_followed(x)) close_extents(x, nil);
  for (const Index g : opened(x)) {
    if (x.s.now[g].holder == nil || x.s.now[g].active != nil || x.s.last[g].active == nil) continue;
    x.depends_on_last = true;
    if (note_if_stale(x, g)) x.s.now[g].active = x.s.last[g].active;
  }
  x.s.next_count[x.component] = x.placed;
  x.s.first_moved[x.component] = x.first_moved;
  if (x.pushed_count != 0) finish_pushes(x);
}

} // namespace

void open_all(Context& x, std::uint8_t kept) {
  x.pushed_count = x.s.on_last[x.component] = 0;
  for (const Index g : x.t.list(x.row.groups)) {
    x.s.group_trail[g] = trail::opened;
    x.s.group_marks[g] &= kept;
    if (x.s.last[g].push.edge != nil) list_push(x, g);
    clear(x, g);
    x.s.now[g].push = Push{};
  }
  for (const Index e : x.t.list(x.row.edges)) x.s.edge_marks[e] = x.s.edge_trail[e] = 0;
  x.s.flipped[x.component] = x.s.rerequested[x.component] = nil;
  if (x.pushed_count != 0) mark_pushers(x);
}

/// Opens the groups that have to be examined: all of them if the trail of the last pass is not known.
void begin(Context& x) {
  x.whole = x.s.news_count[x.component] == nil;
  x.walking = !x.whole;
  x.disturbed = x.settled = false;
  x.opened_count = x.reached_count = x.unopened_count = x.line_count = x.opened_end = x.placed = 0;
  x.whole ? open_all(x, 0) : begin_trail(x);
  x.depends_on_all_stale = false;
  x.depends_on_last = x.pushed_count != 0 || x.s.on_last[x.component] != 0;
}

void decide(Context& x, Index component) {
  x.row = x.t.components[component];
  x.component = component;
  begin(x);
  if (x.s.component[component].has(work::reordered)) {
    x.s.component[component].remove(work::reordered);
    const Index first = x.s.first_root[component];
    if (first != nil && x.s.next_root[first] != nil) sort_roots(x);
  }
  begin_sweep(x);
  x.settled ? keep_all(x) : sweep_all(x);
  finish(x);
}

void end(Context& x) {
  for (const Index e : x.whole ? x.t.list(x.row.edges) : std::span<const TableIndex>{}) leave_unvisited(x, e);
  x.s.news_count[x.component] = nil;
  if (is_followed(x)) end_trail(x);
}

void forget_trail(Context& x) {
  for (Index c = 0; c < x.t.components.size(); ++c) x.s.news_count[c] = x.s.flipped[c] = x.s.rerequested[c] = nil;
  for (Index g = 0; g < x.t.groups.size(); ++g) x.s.now[g] = x.s.last[g];
  for (Index slot = 0; slot < x.t.plan_groups.size(); ++slot) x.s.now.plan[slot] = x.s.last.plan[slot];
}

} // namespace director::arbitration
