// docs/semantics.md, section 4.4: which groups a pass looks at; all others stand as they stood.
// SPDX-License-Identifier: MIT
//
// A unit's decision depends on what units before it claimed, pushed and were denied, on its conditions and requests, on
// whose orders are outdated, and on the last result. So a pass goes along the order as the last one did, and decides
// only units that something different reaches (reach.cpp).
//
// Between passes State::now is what State::last is. A pass opens the groups that it has to look at, each with all above
// it, and clears what is now of these alone. A group that is not opened stands with all below it: the walk passes it in
// one step, and from then on what they have is claimed.

#include "runtime/core/arbitration/trail.hpp"

#include "runtime/core/arbitration/order.hpp"
#include "runtime/core/arbitration/push.hpp"
#include "runtime/core/arbitration/staleness.hpp"

namespace director::arbitration {

namespace {

void remove(Bits& from, std::uint8_t bits) { from &= static_cast<std::uint8_t>(~bits); }

/// The rows of a list of all components that are about this one; they leave it.
template <class ComponentOf, class Take>
void take_own(Context& x, Index* list, Index& count, ComponentOf&& component_of, Take&& take) {
  Index left = 0;
  for (Index i = 0; i < count; ++i) {
    const Index row = list[i];
    if (component_of(row) == x.component) {
      take(row);
    } else {
      list[left++] = row;
    }
  }
  count = left;
}

/// What has to be looked at if something differs from the last pass, or when it has run, is left alone until then.
bool can_stand(const Context& x, Index group) {
  const bool lives_for_need = !x.s.last[group].granted() && x.s.last[group].active != nil;
  if (lives_for_need || x.s.lineage[group].top == nil || (is_outdated(x, group) && !outdates(x, group))) return false;
  const Range edges = x.t.groups[group].edges;
  for (Index e = edges.begin; e != edges.end; ++e) {
    if ((x.s.edge_trail[e] & trail::on_stale) != 0 || optional(x, e))
      return false; // what is optional comes after all else
  }
  return true;
}

bool waits(const Context& x, Index group) {
  const Range edges = x.t.groups[group].edges;
  bool any = false;
  for (Index e = edges.begin; e != edges.end; ++e) any = any || (x.s.edge_trail[e] & trail::waits) != 0;
  return any;
}

/// Who searched for somebody to push looked at much.
void open_waiting(Context& x) {
  for (Index i = 0; i < x.kept_count; ++i) {
    const Index g = x.s.news[x.row.order + i];
    if (!is_opened(x, g) && waits(x, g)) open(x, g);
  }
}

void open_all(Context& x) {
  x.pushed_count = x.s.on_last[x.component] = 0;
  for (const Index g : x.t.list(x.row.groups)) {
    x.s.group_trail[g] = trail::opened;
    x.s.group_marks[g] = 0;
    if (x.s.last[g].push.edge != nil) list_push(x, g);
    clear(x, g);
  }
  for (const Index e : x.t.list(x.row.edges)) x.s.edge_marks[e] = x.s.edge_trail[e] = 0;
}

/// By the next pass: something of it is decided again whatever happens, or what is below it stands apart from it.
bool has_to_be_looked_at(const Context& x, Index group) {
  if (injected(Fault::what_is_always_decided_is_overlooked)) return false;
  const GroupAssignment& now = x.s.now[group];
  if (is_outdated(x, group) || (!now.granted() && now.active != nil)) return true;
  const Range edges = x.t.groups[group].edges;
  for (Index e = edges.begin; e != edges.end; ++e) {
    if ((x.s.edge_trail[e] & (trail::on_stale | trail::waits)) != 0 || optional(x, e)) return true;
  }
  return false;
}

} // namespace

/// From what changed since the last pass to the units that it reaches.
void begin_trail(Context& x) {
  const Index news = x.s.news_count[x.component];
  x.whole = news == nil;
  x.disturbed = false;
  x.walking = !x.whole;
  x.opened_count = x.reached_count = x.kept_count = x.stale_kept = 0;
  const auto of_group = [&](Index g) { return x.s.run_queue[g].component; };
  const auto of_edge = [&](Index e) { return x.s.run_queue[x.s.request[e].target].component; };
  if (x.whole) {
    open_all(x);
    take_own(x, x.s.flipped, x.flipped_count, of_group, [](Index) {});
    take_own(x, x.s.rerequested, x.rerequested_count, of_edge, [](Index) {});
    return mark_pushers(x);
  }
  x.pushed_count = x.s.pushed_count[x.component];
  for (const Index g : pushed_groups(x)) {
    open(x, g);
    x.s.group_marks[g] |= mark::listed;
  }
  mark_pushers(x);
  // The last result first: what is reached now belongs to the next one.
  Index* const rows = x.s.news + x.row.order;
  Index kept = 0;
  for (Index i = 0; i < news; ++i) {
    const Index g = rows[i];
    const std::uint8_t bits = x.s.group_trail[g];
    remove(x.s.group_trail[g], trail::disturbed | trail::again);
    if ((bits & trail::disturbed) != 0) take_up_last(x, g);
    if ((bits & trail::again) == 0) continue;
    if (can_stand(x, g)) {
      rows[kept++] = g;
      if (is_outdated(x, g)) ++x.stale_kept;
    } else {
      open(x, g);
    }
  }
  take_own(x, x.s.flipped, x.flipped_count, of_group, [&](Index g) {
    remove(x.s.group_trail[g], trail::touched);
    reach(x, g);
  });
  Index from = nil;
  take_own(x, x.s.rerequested, x.rerequested_count, of_edge, [&](Index e) {
    remove(x.s.edge_trail[e], trail::changed);
    take_up(x, e, requester(x, e) != from);
    from = requester(x, e);
  });
  // Whose orders may be outdated: who is to run, and who was asked just now.
  const Counters& c = *x.s.counters;
  const auto look = [&](Index g) {
    if (of_group(g) == x.component && !is_outdated(x, g) && outdates(x, g)) open(x, g);
  };
  for (Index g = c.queue_first; g != nil; g = x.s.run_queue[g].runs_before) look(g);
  for (Index i = 0; i < c.touched_count; ++i) look(x.s.touched[i]);
  x.kept_count = kept;
  if (x.disturbed) open_waiting(x);
}

/// Something is, or may be, another than in the last pass.
void disturb(Context& x) {
  if (x.disturbed) return;
  x.disturbed = true;
  open_waiting(x);
}

/// This pass looks at the group, and so at all above it.
void open(Context& x, Index group) {
  if (is_opened(x, group) || (x.s.last[group].holder != nil && is_passed(x, group))) return;
  for (;;) {
    x.s.group_trail[group] |= trail::opened;
    remove(x.s.group_marks[group], mark::outdated);
    x.s.opened[x.row.order + x.opened_count++] = group;
    clear(x, group);
    group = requester_of_holder(x, x.s.last[group]);
    if (group == nil || is_opened(x, group)) return;
  }
}

/// A condition of one of its providers flipped, or it is to be looked at as if one had.
void touch_group(Context& x, Index group) {
  if ((x.s.group_trail[group] & trail::touched) != 0) return;
  x.s.group_trail[group] |= trail::touched;
  x.s.flipped[x.flipped_count++] = group;
}

/// What nobody visited is not queued. What the pass did is noted for the next one, and its marks are removed.
void end_trail(Context& x) {
  const auto leave = [&](Index edge) {
    if ((x.s.edge_marks[edge] & mark::visited) == 0) x.s.queued[edge] = Queued{};
  };
  for (const Index e : x.whole ? x.t.list(x.row.edges) : std::span<const Index>{}) leave(e);
  Index& news = x.s.news_count[x.component] = nil;
  if (!is_followed(x)) return;
  for (Index i = 0; i < x.denied_count; ++i) { // what was forgotten counts again in the next pass
    if ((x.s.group_marks[x.s.denied[i]] & mark::forgotten) != 0) touch_group(x, x.s.denied[i]);
  }
  for (Index i = 0; i < x.reached_count; ++i) {
    const Index e = x.s.reached[i], from = requester(x, e);
    if (!x.whole && (from == nil || is_opened(x, from))) leave(e); // otherwise it stands as it stood
    x.s.edge_trail[e] &= trail::kept;
  }
  news = 0;
  for (Index i = 0; i < x.kept_count; ++i) {
    const Index g = x.s.news[x.row.order + i];
    if (is_opened(x, g)) continue;
    x.s.group_trail[g] |= trail::again;
    x.s.news[x.row.order + news++] = g;
  }
  Index& pushed = x.s.pushed_count[x.component] = 0;
  for (const Index g : pushed_groups(x)) {
    if (x.s.now[g].push.edge != nil) x.s.pushed[x.row.order + pushed++] = g;
  }
  clear_marks(x);
  for (Index at = x.limbo_begin; at < x.placed; ++at) {
    const Index g = x.s.next_order[x.row.order + at];
    x.s.group_trail[g] |= trail::again;
    x.s.lineage[g].top = nil;
  }
  for (const Index g : opened(x)) {
    const GroupAssignment& now = x.s.now[g];
    Bits& bits = x.s.group_trail[g];
    if (now.holder != nil && has_to_be_looked_at(x, g)) bits |= trail::again;
    if ((bits & (trail::disturbed | trail::again)) != 0) x.s.news[x.row.order + news++] = g;
    remove(bits, trail::opened | trail::moved);
    x.s.group_marks[g] &= mark::differs | mark::outdated;
  }
}

/// On edges, and where the walk passed.
void clear_marks(Context& x) {
  const auto clear_edge = [&](Index e) {
    x.s.edge_marks[e] = 0;
    remove(x.s.group_trail[x.t.edges[e].target], trail::passed);
  };
  for (const Index e : x.t.list(x.row.edges)) {
    if (x.t.edges[e].requester != nil) break; // those of root come first
    clear_edge(e);
  }
  for (const Index g : opened(x)) {
    const Range edges = x.t.groups[g].edges;
    for (Index e = edges.begin; e != edges.end; ++e) clear_edge(e);
  }
}

} // namespace director::arbitration
