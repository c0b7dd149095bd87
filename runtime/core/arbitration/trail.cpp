// docs/semantics.md, section 4.4: the groups that a pass opens; all others keep their last assignment.
// SPDX-License-Identifier: MIT
//
// runtime/core/README.md, "Decide again", says what is opened and passed by, and why the result is the same.

#include "runtime/core/arbitration/trail.hpp"

#include "runtime/core/arbitration/grant.hpp"
#include "runtime/core/arbitration/pass.hpp"
#include "runtime/core/arbitration/push.hpp"

const char director::part::trail = 0;

namespace director::arbitration {

namespace {

/// Whether the edge is decided in every pass, or, as it searched for a provider to push, as soon as anything differs.
bool is_decided_again(const Context& x, Index edge) { return x.s.edge_trail[edge].has(trail::on_stale | trail::waits); }

/// Whether the pass has to open the requester, whatever differs: the edge is decided again, or is optional and so
/// ordered elsewhere.
bool opens_always(const Context& x, Index edge) { return is_decided_again(x, edge) || optional(x, edge); }

/// Whether something may differ on which the last decision about the edge depends.
DIRECTOR_INLINE bool is_affected(const Context& x, Index edge) {
  const Bits bits = x.s.edge_trail[edge];
  if (bits.has(trail::reached | trail::on_stale)) return true;
  const bool searches = bits.has(trail::waits) && x.disturbed;
  return searches || (bits.has(trail::in_line) && !taken(x, edge));
}

/// Whether an affected edge is refused again for the reason of the last pass: its target is claimed, or a need of each
/// provider is, or there is no chain of pushes for the condition that it waits for.
[[gnu::noinline]] bool has_same_reason(Context& x, Index edge) {
  if (x.s.edge_marks[edge].has(mark::pushes)) return false;
  const Bits bits = x.s.edge_trail[edge];
  const bool again = bits.has(trail::reached)
                         ? x.s.queued[edge].why == Why::blocked &&
                               (taken(x, edge) || (!bits.has(trail::in_line) && needs_claimed(x, target(x, edge))))
                         : bits.has(trail::waits) && finds_no_push(x, edge);
  if (again) ++x.work;
  return again;
}

/// Whether the pass follows only from a change of the assignment by the last one, on which no decision depends.
bool is_settled(const Context& x) {
  if (x.s.component[x.component].has(work::changed)) return false;
  if (x.pushed_count != 0 || x.had_limbo || x.reached_count != 0) return false;
  // Requests that ended because their requester stopped: it may still hold their targets, as needs.
  if (x.s.rerequested[x.component] != nil) return false;
  for (Index e = x.s.first_root[x.component]; e != nil; e = x.s.next_root[e]) {
    if (is_decided_again(x, e)) return false;
  }
  for (Index i = 0; i < x.unopened_count; ++i) {
    const Index g = x.s.news[x.row.order + i];
    if (is_marked_stale(x, g) && !becomes_stale(x, g) && x.s.run_queue[g].stale_matters != 0) return false;
    if (any(x.t.groups[g].edges.rows(), [&](Index e) { return is_decided_again(x, e); })) return false;
  }
  return true;
}

/// Clears the marks of an edge that the walk may have visited, and of its target, which it may have passed by.
inline void clear_marks(Context& x, Index edge) {
  x.s.edge_marks[edge] = 0;
  x.s.group_trail[x.t.edges[edge].target].remove(trail::passed);
}

/// Copies `count` groups of the last order, from this place on, to the new one.
DIRECTOR_INLINE void copy_order(Context& x, Index from, Index count) {
  if (from != x.placed) {
    for (Index i = 0; i < count; ++i) put(x, x.s.order[x.row.order + from + i], static_cast<Index>(x.placed + i));
  }
  x.placed = static_cast<Index>(x.placed + count);
  x.inherited = static_cast<Index>(x.inherited + count);
}

} // namespace

/// Opens the groups that changed since the last pass, and finds the units that this reaches.
void begin_trail(Context& x) {
  const Index news = x.s.news_count[x.component];
  const Index held = x.s.order_count[x.component];
  x.had_limbo = held != 0 && was_in_limbo(x, x.s.order[x.row.order + held - 1]); // limbo is last in the order
  x.pushed_count = x.s.pushed_count[x.component];
  if (x.pushed_count != 0) mark_pushers(x);
  // The last result first: bits that are set from here on are notes for the next pass.
  Index* const rows = x.s.news + x.row.order;
  for (Index i = 0; i < news; ++i) {
    const Index g = rows[i];
    const std::uint8_t bits = x.s.group_trail[g];
    x.s.group_trail[g].remove(trail::disturbed | trail::again);
    if ((bits & trail::disturbed) != 0) reach_by_last_result(x, g);
    if ((bits & trail::again) != 0) rows[x.unopened_count++] = g;
  }
  x.settled = is_settled(x);
  if (x.settled) return;
  Index kept = 0;
  for (Index i = 0; i < x.unopened_count; ++i) {
    const Index g = rows[i];
    const bool stays_stale = is_marked_stale(x, g) && becomes_stale(x, g);
    const auto opens_it = [&](Index e) { return opens_always(x, e); };
    if (stays_stale && !any(x.t.groups[g].edges.rows(), opens_it) && !(x.had_limbo && was_in_limbo(x, g))) {
      rows[kept++] = g;
    } else {
      open(x, g);
    }
  }
  x.unopened_count = kept;
  for (Index g = std::exchange(x.s.flipped[x.component], nil); g != nil; g = x.s.next_flipped[g]) {
    x.s.group_trail[g].remove(trail::flipped);
    reach(x, g);
  }
  Index from = nil;
  for (Index e = std::exchange(x.s.rerequested[x.component], nil); e != nil; e = x.s.next_rerequested[e]) {
    reach_by_request(x, e, x.t.edges[e].requester != from);
    from = x.t.edges[e].requester;
  }
  // Groups that may have become stale: those in the run queue, and those requested in this micro-step.
  const Counters& c = *x.s.counters;
  const auto open_if_stale = [&](Index g) {
    if (x.s.run_queue[g].component != x.component || x.t.groups[g].edges.empty()) return;
    if (!is_marked_stale(x, g) && becomes_stale(x, g)) open(x, g);
  };
  for (Index g = c.queue_first; g != nil; g = x.s.run_queue[g].runs_before) open_if_stale(g);
  for (Index i = 0; i < c.touched_count; ++i) open_if_stale(x.s.touched[i]);
}

/// Whether the walk has passed by the group, or one above it, so that it counts as claimed.
bool is_passed(const Context& x, Index group) {
  for (; group != nil; group = requester_of_holder(x, x.s.last[group])) {
    if (x.s.group_trail[group].has(trail::passed)) return true;
    if (is_opened(x, group)) return false;
  }
  return false;
}

void open_with_above(Context& x, Index group) {
  const bool walk_began = x.placed != 0; // before, no group was passed by
  if (walk_began && x.s.last[group].holder != nil && is_passed(x, group)) return;
  for (;;) {
    x.s.group_trail[group] |= trail::opened;
    x.s.group_marks[group].remove(mark::stale);
    x.s.opened[x.row.order + x.opened_count++] = static_cast<TableIndex>(group);
    if (x.s.last[group].holder != nil && x.s.place[group] >= x.opened_end)
      x.opened_end = static_cast<Index>(x.s.place[group] + 1);
    clear(x, group);
    group = requester_of_holder(x, x.s.last[group]);
    if (group == nil || is_opened(x, group)) return;
  }
}

/// Notes for the next pass what it has to open, and removes the marks of this one.
void end_trail(Context& x) {
  Index& news = x.s.news_count[x.component];
  for (Index i = 0; i < x.reached_count; ++i) {
    const Index e = x.s.reached[i], from = x.t.edges[e].requester;
    // Other edges keep their decision, also those of root behind the place where the walk ended.
    if (!x.whole && (from == nil ? x.s.request[e].level == nil : is_opened(x, from) && !is_passed(x, from)))
      leave_unvisited(x, e);
    x.s.edge_trail[e] &= trail::kept;
  }
  news = 0;
  for (Index i = 0; i < x.unopened_count; ++i) {
    const Index g = x.s.news[x.row.order + i];
    if (is_opened(x, g)) continue;
    x.s.group_trail[g] |= trail::again;
    x.s.news[x.row.order + news++] = g;
  }
  Index& pushed = x.s.pushed_count[x.component] = 0;
  for (const Index g : pushed_groups(x)) {
    x.s.group_marks[g].remove(mark::listed | mark::busy);
    if (x.s.last[g].push.edge != nil) clear_marks(x, x.s.last[g].push.edge);
    if (x.s.now[g].push.edge != nil) x.s.pushed[x.row.order + pushed++] = g;
  }
  for (Index e = x.s.first_root[x.component]; e != x.rest; e = x.s.next_root[e]) clear_marks(x, e);
  for (Index at = x.limbo_begin; at < x.placed; ++at) x.s.group_trail[x.s.next_order[x.row.order + at]] |= trail::again;
  // A pass over the whole component does not note places that move.
  const bool any_moved = x.whole && any(opened(x), [&](Index g) { return x.s.group_marks[g].has(mark::differs); });
  for (const Index g : opened(x)) {
    const GroupAssignment& now = x.s.now[g];
    Bits& bits = x.s.group_trail[g];
    if (any_moved || x.s.group_marks[g].has(mark::forgotten)) bits |= trail::disturbed; // its last holder counts again
    bool again = is_marked_stale(x, g);
    const bool loses = now.holder == nil && x.s.last[g].holder != nil && !x.whole;
    for (const Index e : x.t.groups[g].edges.rows()) {
      clear_marks(x, e);
      again = again || opens_always(x, e);
      if (loses) x.s.queued[e] = Queued{};
    }
    if (again && now.holder != nil) bits |= trail::again;
    if ((bits & (trail::disturbed | trail::again)) != 0) x.s.news[x.row.order + news++] = g;
    bits.remove(trail::opened | trail::moved | trail::passed);
    x.s.group_marks[g] &= mark::differs | mark::stale;
  }
}

/// Leaves a group that was not opened, with all below it, at its place with its assignment.
void pass_by(Context& x, Index group) {
  close_extents(x, requester_of_holder(x, x.s.last[group]));
  x.s.group_trail[group] |= trail::passed;
  copy_order(x, x.s.place[group], x.s.extent[group]);
}

/// Whether the decision about an edge that was reached, searched for a provider to push, or is in line, remains.
bool is_refused_again(Context& x, Index edge) { return !is_affected(x, edge) || has_same_reason(x, edge); }

/// Copies the rest of the order if nothing below this edge of root and those behind it was opened or reached.
bool copy_unchanged_rest(Context& x, Index root) {
  if (x.pushed_count != 0 || x.postponed != 0 || x.row.groups.size() <= 4 * x.most_decided_whole) {
    x.undecided =
        static_cast<Index>(x.t.edges.size()); // no edge: it is not called again, which costs more than it saves
    return false;
  }
  for (const WaitingLine& line : std::span(x.waiting_lines).first(x.line_count)) {
    if (line.first != nil && holder_now(x, line.group) == nil) return false;
  }
  Index from = x.s.order_count[x.component];
  for (Index e = root; e != nil; e = x.s.next_root[e]) {
    if (x.s.request[e].level == nil) continue;
    const Index group = x.t.edges[e].target;
    const bool was_held = x.s.last[group].holder == e;
    const bool affected = is_affected(x, e) || (was_held && x.s.place[group] < x.opened_end);
    if (affected) {
      x.undecided = e;
      return false;
    }
    if (was_held && x.s.place[group] < from) from = x.s.place[group];
  }
  close_extents(x, nil);
  copy_order(x, from, static_cast<Index>(x.s.order_count[x.component] - from));
  x.rest = root;
  return true;
}

/// Sets the extents of the groups placed last, up to this group, below which the next one is placed (nil: below root).
void close_extents(Context& x, Index group) {
  while (x.top != group && x.top != nil) {
    x.s.extent[x.top] = static_cast<Index>(x.placed - x.s.place[x.top]);
    x.top = requester_of_holder(x, x.s.now[x.top]);
  }
}

/// Repeats the last decision about an edge of a group that was opened: it claims again what it had.
void claim_again(Context& x, Index edge) {
  x.s.edge_marks[edge] |= mark::visited;
  if (was_granted(x, edge)) {
    const Index group = target(x, edge), provider = x.s.last[group].active;
    grant_target(x, edge, provider);
    const Index end = x.t.providers[provider].needs.empty() ? Index{0} : entries_of(x, group, x.s.last);
    if (end != 0) claim_plan(x, group, provider, 0, end);
  } else {
    x.s.edge_marks[edge] |= mark::refused;
  }
}

} // namespace director::arbitration
