// docs/semantics.md, section 4.4: the units that a change reaches, so that they are decided again.
// SPDX-License-Identifier: MIT
//
// A change is an input, or a group whose claim, push or place in the order differs from the last pass. The units that
// it reaches are found through the tables: each group lists the groups whose plans may contain it (Group::users).

#include "runtime/core/arbitration/push.hpp"
#include "runtime/core/arbitration/trail.hpp"

namespace director::arbitration {

namespace {

/// Compares the claims of a member with the last pass, to reach others if they differ. Providers make no difference.
void compare_claims(Context& x, Index edge) {
  const Index group = target(x, edge);
  const GroupAssignment& now = x.s.now[group];
  const bool runs = is_opened(x, group) && now.holder == edge && now.granted(), ran = was_granted(x, edge);
  if (!runs && !ran) return;
  compare_claim(x, group);
  if (x.t.groups[group].simple) return;
  const auto compare_plan = [&](const Assignment& of) {
    const Index end = entries_of(x, group, of);
    for (Index i = 0; i < end; ++i) compare_claim(x, x.s.entry[i].group);
  };
  if (ran) compare_plan(x.s.last);
  const bool same = ran && now.planned == x.s.last[group].planned && x.t.groups[group].slots.empty();
  if (runs && !same) compare_plan(x.s.now);
}

/// Calls take(edge) for the units whose decision may depend on the group, if is(bits of its trail). A group that is not
/// held requests nothing, and when it becomes held, all its requests are decided anyway.
template <class Is, class Take>
void each_user_edge(Context& x, Index group, const Is& is, const Take& take) {
  for (const Index user : x.t.list(x.t.groups[group].users)) {
    for (const Index e : x.t.list(x.t.groups[user].requesters)) {
      if (!is(x.s.edge_trail[e])) continue;
      const Index from = x.t.edges[e].requester;
      if (x.s.request[e].level != nil && (from == nil || x.s.last[from].holder != nil)) take(e);
    }
  }
  const Index pusher = x.s.last[group].push.edge;
  if (pusher != nil) reach_edge(x, pusher);
}

/// Members of a unit are tried at the place of the first of them among its siblings, which may be another place now.
/// What is below siblings that are apart, between the old place and the new one, may find what a member holds free.
void reach_unit(Context& x, Index requester) {
  const Range edges = x.t.groups[requester].edges;
  const auto apart = [&](Index e) { return requested(x, e) && x.t.levels[x.s.request[e].level].apart; };
  if (!any(edges.rows(), apart)) return;
  for (const Index e : edges.rows()) {
    if (!apart(e) && x.s.last[target(x, e)].holder == e) reach_all_below(x, target(x, e));
  }
}

bool is_in_line(const Context& x, Index edge) { return x.s.edge_trail[edge].has(trail::in_line); }

} // namespace

/// Called before the walk passes by this group: if a group with a waiting line is free by now, the requests in line
/// that are below this group are reached; and once one is reached, all others.
void check_lines(Context& x, Index group) {
  const auto end = static_cast<Index>(x.s.place[group] + x.s.extent[group]);
  for (WaitingLine& line : std::span(x.waiting_lines).first(x.line_count)) {
    if (line.first >= end || holder_now(x, line.group) != nil) continue;
    line.first = nil;
    bool found = false;
    for (const Index e : x.t.list(x.t.groups[line.group].requesters)) {
      const Index from = x.t.edges[e].requester;
      if (!is_in_line(x, e) || from == nil || x.s.last[from].holder == nil || is_opened(x, from)) continue;
      if (x.s.place[from] < end || line.moves) {
        found = true;
        reach_edge(x, e);
      } else if (x.s.place[from] < line.first) {
        line.first = x.s.place[from];
      }
    }
    line.moves = line.moves || found;
  }
}

/// Replaces what the decision about an edge depends on, bits of trail::kept.
void note_dependence(Context& x, Index edge, std::uint8_t bits) {
  Bits& trail = x.s.edge_trail[edge];
  const bool was = trail.has(trail::on_last), is = (bits & trail::on_last) != 0;
  if (is && !was) ++x.s.on_last[x.component];
  if (was && !is) --x.s.on_last[x.component];
  trail = static_cast<std::uint8_t>((trail & ~trail::kept) | bits);
}

/// Opens the groups that the unit held, since it may lose them, and forgets what its last decision depended on.
void begin_followed(Context& x, Index count) {
  x.on_last = x.depends_on_last;
  x.depends_on_last = x.depends_on_stale = false;
  for (Index at = 0; at < count; ++at) {
    const Index edge = x.s.unit[at], group = target(x, edge);
    note_dependence(x, edge, 0);
    if (x.s.edge_marks[edge].has(mark::pushes)) withdraw_pushes(x, edge);
    if (x.s.last[group].holder != edge) continue;
    open(x, group);
    if (!was_granted(x, edge) || x.t.groups[group].simple) continue;
    const Index end = entries_of(x, group, x.s.last);
    for (Index i = 0; i < end; ++i) open(x, x.s.entry[i].group);
  }
}

/// Notes what the decision depends on, and reaches other units if it differs from that of the last pass.
void compare_with_last(Context& x, Index count) {
  const auto bits =
      static_cast<std::uint8_t>((x.depends_on_last ? trail::on_last : 0) | (x.depends_on_stale ? trail::on_stale : 0) |
                                (x.depends_on_requester ? trail::on_requester : 0));
  x.depends_on_last = x.depends_on_last || x.on_last;
  for (Index at = 0; at < count; ++at) {
    const Index edge = x.s.unit[at];
    note_dependence(x, edge, static_cast<std::uint8_t>(bits | (x.s.edge_trail[edge] & trail::waits)));
    compare_claims(x, edge);
  }
  if (x.pushed_count == 0) return;
  const std::span<const Index> unit{x.s.unit, count};
  const auto ours = [&](Index edge) { return any(unit, [&](Index member) { return member == edge; }); };
  bool lost = false;
  for (const Index g : pushed_groups(x)) {
    const Push &now = x.s.now[g].push, &last = x.s.last[g].push;
    if (now == last) continue;
    const bool was_ours = ours(last.edge);
    lost = lost || was_ours;
    if (was_ours || ours(now.edge)) reach(x, g);
  }
  // Pushes that serve another push stay: the next pass decides about the others.
  for (Index at = 0; lost && at < count; ++at) x.s.edge_trail[x.s.unit[at]] |= trail::on_stale;
}

/// Makes this pass decide the unit of the edge again.
void reach_edge(Context& x, Index edge) {
  if (x.whole || x.s.edge_trail[edge].has(trail::reached)) return;
  x.s.edge_trail[edge] |= trail::reached;
  x.s.reached[x.reached_count++] = edge;
  const Index from = x.t.edges[edge].requester;
  if (from != nil) open(x, from);
}

/// Reaches the unit of an edge that is requested at another level, or no longer, and with its siblings the unit with
/// another member. Others are reached once its claims differ, except searches for pushes.
void reach_by_request(Context& x, Index edge, bool with_siblings) {
  const Index group = target(x, edge), from = x.t.edges[edge].requester;
  reach_edge(x, edge);
  if (from != nil && with_siblings) {
    for (const Index e : x.t.groups[from].edges.rows()) reach_edge(x, e);
    reach_unit(x, from);
  }
  x.disturbed = true;
  reach_pushes_of(x, edge);
  if (x.s.last[group].holder == edge) reach_all_below(x, group);
}

/// Reaches the units that depend on the last assignment of the group, which the last pass changed.
void reach_by_last_result(Context& x, Index group) {
  x.disturbed = true;
  const auto depends = [](std::uint8_t bits) { return (bits & (trail::on_last | trail::in_line)) == trail::on_last; };
  each_user_edge(x, group, depends, [&](Index e) { reach_edge(x, e); });
}

void reach_users(Context& x, Index group) {
  if (x.s.group_trail[group].has(trail::disturbed)) return;
  x.s.group_trail[group] |= trail::disturbed;
  x.disturbed = true;
  open(x, group);
  bool line = false;
  const bool has_room = x.line_count < x.waiting_lines.size();
  const auto is_new = [](std::uint8_t bits) { return (bits & trail::reached) == 0; };
  each_user_edge(x, group, is_new, [&](Index e) { // a request in line depends on its target alone
    const bool is_target = x.t.edges[e].target == group;
    if (!is_in_line(x, e) || (is_target && !has_room)) return reach_edge(x, e);
    line = line || is_target;
  });
  if (line) x.waiting_lines[x.line_count++] = {group, 0, false};
}

/// Reaches the group and all groups below it: its holder differs, or has another place in the order.
void reach_all_below(Context& x, Index group) {
  Index found = 0;
  const auto add = [&](Index g) {
    reach(x, g);
    if (x.s.group_trail[g].has(trail::moved)) return;
    x.s.group_trail[g] |= trail::moved;
    x.s.reach[found++] = g;
  };
  add(group);
  for (Index i = 0; i < found; ++i) {
    for (const Index e : x.t.groups[x.s.reach[i]].edges.rows()) {
      reach_edge(x, e);
      reach_pushes_of(x, e);
      if (x.s.last[x.t.edges[e].target].holder == e) add(x.t.edges[e].target);
    }
  }
}

} // namespace director::arbitration
