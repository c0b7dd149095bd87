// docs/semantics.md, section 4.4: units. The requests and needs of a claimed group come next in the walk.
// SPDX-License-Identifier: MIT

#include "runtime/core/arbitration/grant.hpp"
#include "runtime/core/arbitration/pass.hpp"
#include "runtime/core/arbitration/push.hpp"
#include "runtime/core/base/heap_sort.hpp"

const char director::part::units = 0;

namespace director::arbitration {

/// Puts the edges of a placed group on the stack of the walk; requests of one that is only needed, while it is stale.
void add_candidates(Context& x, Index group) {
  const Index source = stale_source(x, group);
  const bool is_stale = source != up_to_date, requests = is_stale || x.s.now[group].granted();
  std::uint8_t marks = requests ? std::uint8_t{0} : mark::tried;
  if (is_stale) marks |= mark::below_stale;
  const auto known = static_cast<std::uint8_t>((is_stale ? trail::stale : 0) | (requests ? trail::requests : 0));
  const auto differs = static_cast<std::uint8_t>((x.s.group_trail[group] & (trail::stale | trail::requests)) ^ known);
  x.s.group_trail[group].remove(trail::stale | trail::requests);
  x.s.group_trail[group] |= known;
  const Index base = x.ahead;
  Index together = 0, member = nil;
  bool stale_matters = false;
  const Range edges = x.t.groups[group].edges;
  for (Index e = edges.end; e != edges.begin;) {
    --e;
    const Index level = x.s.request[e].level;
    if (!x.whole && level != nil) {
      const bool on_requester = x.s.edge_trail[e].has(trail::on_requester);
      stale_matters = stale_matters || on_requester;
      if ((differs & (on_requester ? trail::requests | trail::stale : trail::requests)) != 0) {
        reach_edge(x, e);
        if (!requests) reach_pushes_of(x, e);
      }
    }
    if (level == nil || !requests) {
      if (holder_now(x, x.t.edges[e].target) != e) {
        if (differs != 0 && !x.whole && x.s.last[x.t.edges[e].target].holder == e)
          reach_all_below(x, x.t.edges[e].target);
        continue;
      }
      if (level == nil) {
        x.s.candidate[x.ahead++] = e;
        continue;
      }
    }
    stale_matters = stale_matters || !x.s.now[group].granted(); // this request counts only while it is stale
    const Level& row = x.t.levels[level];
    std::uint8_t all = marks;
    if (row.optional) all |= mark::optional;
    if (row.optional || row.apart) {
      all |= mark::alone;
    } else {
      ++together;
      member = e;
    }
    x.s.edge_marks[e] |= all;
    x.s.candidate[x.ahead++] = e;
  }
  if (together == 1) x.s.edge_marks[member] |= mark::alone;
  if (stale_matters && is_stale && source != nil) x.s.run_queue[source].stale_matters = 1;
  heap_sort({x.s.candidate + base, static_cast<std::size_t>(x.ahead - base)}, [&](Index a, Index b) {
    return compare_siblings(x, {b, false}, {a, false}, true) < 0; // the next edge is the last one
  });
}

/// Tries the unit whose first member is this edge; others are on the stack. Below a stale group each is a unit.
void try_unit(Context& x, Index edge, bool below_stale) {
  Index count = 0;
  x.s.unit[count++] = edge;
  const Index from = x.t.edges[edge].requester;
  for (Index i = x.ahead; i > 0; --i) {
    const Index e = x.s.candidate[i - 1];
    if (x.t.edges[e].requester != from) break;
    if (x.s.request[e].level == nil || x.s.edge_marks[e].has(mark::alone)) continue;
    x.s.edge_marks[e] |= mark::tried;
    x.s.unit[count++] = e;
  }
  const std::span<const Index> unit{x.s.unit, count};
  if (!any(unit, [&](Index e) { return !stands(x, e); })) {
    for (const Index e : unit) claim_again(x, e);
    return;
  }
  begin_decision(x, count);
  x.depends_on_requester = below_stale && count > 1;
  if (below_stale || count == 1) {
    for (Index i = 0; i < count; ++i) decide_alone(x, x.s.unit[i], below_stale);
  } else {
    for (Index i = 0; i < count; ++i) x.s.member[i].edge = x.s.unit[i];
    try_members(x, count, false);
  }
  end_decision(x, count);
}

} // namespace director::arbitration
