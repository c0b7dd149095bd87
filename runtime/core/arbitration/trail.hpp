#pragma once
// SPDX-License-Identifier: MIT
// Incremental passes: the groups that a pass opens, that is, examines, and the units that it decides again, because
// something on which their decision depends differs from the last pass (reach.cpp). docs/semantics.md, section 4.4.

#include "runtime/core/arbitration/choices.hpp"
#include "runtime/core/arbitration/staleness.hpp"

#include <utility>

namespace director::arbitration {

DIRECTOR_PART void begin_trail(Context& x);
DIRECTOR_PART void end_trail(Context& x);
DIRECTOR_PART void open_with_above(Context& x, Index group);
DIRECTOR_PART bool is_refused_again(Context& x, Index edge);
DIRECTOR_PART void claim_again(Context& x, Index edge);
DIRECTOR_PART void pass_by(Context& x, Index group);
DIRECTOR_PART void close_extents(Context& x, Index group);
DIRECTOR_PART bool copy_unchanged_rest(Context& x, Index root);

// What a change reaches: reach.cpp.
DIRECTOR_PART void check_lines(Context& x, Index group);
DIRECTOR_PART void note_dependence(Context& x, Index edge, std::uint8_t bits);
DIRECTOR_PART void begin_followed(Context& x, Index count);
DIRECTOR_PART void compare_with_last(Context& x, Index count);
DIRECTOR_PART void reach_edge(Context& x, Index edge);
void reach_by_request(Context& x, Index edge, bool with_siblings);
void reach_by_last_result(Context& x, Index group);
DIRECTOR_PART void reach_users(Context& x, Index group);
DIRECTOR_PART void reach_all_below(Context& x, Index group);

/// Makes this pass decide again the units whose decision may depend on the group.
inline void reach(Context& x, Index group) {
  if (!x.whole) reach_users(x, group);
}

/// Reaches all below the group if its claim differs. A need is claimed with the group that has it, a request in turn.
inline void compare_claim(Context& x, Index group) {
  const GroupAssignment &now = x.s.now[group], &last = x.s.last[group];
  if (!x.whole && (now.holder != last.holder || now.needed() != last.needed())) reach_all_below(x, group);
}

/// Makes this pass examine the group, and all above it.
inline void open(Context& x, Index group) {
  if (!is_opened(x, group)) open_with_above(x, group);
}

/// Takes back all but a push, which stays until the unit that made it is decided again.
DIRECTOR_ONE_COPY inline void clear(Context& x, Index group) {
  GroupAssignment& now = x.s.now[group];
  now.holder = now.active = now.planned = nil;
  now.flags = 0;
  x.s.run_queue[group].stale_matters = 0;
  if (!x.row.alternatives) return;
  for (const Index slot : x.t.groups[group].slots.rows()) x.s.now.plan[slot] = nil;
}

/// Lists a group as opened whose push differs, and whose claim stays, also if it was passed by.
inline void open_as_it_is(Context& x, Index group) {
  if (is_opened(x, group)) return;
  x.s.group_trail[group] |= trail::opened | trail::passed;
  x.s.opened[x.row.order + x.opened_count++] = static_cast<TableIndex>(group);
}

/// Whether passes over a component are incremental: in one of few groups, finding what a change reaches costs more.
inline bool is_followed(const Context& x, const Component& row) { return row.groups.size() > x.most_decided_whole; }
inline bool is_followed(const Context& x) { return is_followed(x, x.row); }

/// Whether the last decision about the edge remains: nothing that it depends on differs, or it is refused again.
inline bool stands(Context& x, Index edge) {
  if (x.whole) return false;
  const std::uint8_t bits = x.s.edge_trail[edge];
  if ((bits & trail::on_stale) != 0) return false;
  return (bits & (trail::reached | trail::waits | trail::in_line)) == 0 || is_refused_again(x, edge);
}

/// The groups that the pass has opened; all others keep their last assignment.
inline std::span<const TableIndex> opened(const Context& x) {
  return x.whole ? x.t.list(x.row.groups) : std::span<const TableIndex>{x.s.opened + x.row.order, x.opened_count};
}

/// Whether changes of the group are noted for the next pass.
inline bool is_noted(const Context& x, Index group) {
  return is_followed(x, x.t.components[x.s.run_queue[group].component]);
}

/// Notes for the next pass that a condition of a provider flipped.
inline void note_flipped(Context& x, Index group) {
  if (!is_noted(x, group) || x.s.group_trail[group].has(trail::flipped)) return;
  x.s.group_trail[group] |= trail::flipped;
  x.s.next_flipped[group] = std::exchange(x.s.flipped[x.s.run_queue[group].component], group);
}

/// Notes for the next pass that the edge is requested at another level, or no longer.
inline void note_rerequest(Context& x, Index edge) {
  const Index group = x.s.request[edge].target;
  if (!is_noted(x, group) || x.s.edge_trail[edge].has(trail::changed)) return;
  x.s.edge_trail[edge] |= trail::changed;
  x.s.next_rerequested[edge] = std::exchange(x.s.rerequested[x.s.run_queue[group].component], edge);
}

/// An edge that the walk did not reach is not queued.
inline void leave_unvisited(Context& x, Index edge) {
  if (!x.s.edge_marks[edge].has(mark::visited)) x.s.queued[edge] = Queued{};
}

inline void begin_decision(Context& x, Index count) {
  ++x.work;
  x.depends_on_requester = false;
  for (Index at = 0; at < count; ++at) x.s.edge_marks[x.s.unit[at]] |= mark::visited;
  if (is_followed(x)) begin_followed(x, count);
}

inline void end_decision(Context& x, Index count) {
  if (x.depends_on_requester) note_if_stale(x, x.t.edges[x.s.unit[0]].requester);
  if (is_followed(x)) compare_with_last(x, count);
}

} // namespace director::arbitration
