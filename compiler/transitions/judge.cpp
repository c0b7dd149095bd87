// Header: compiler/transitions/judge.hpp. Test: tests/compiler/transitions/matrix_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/transitions/judge.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace director::compiler::transitions {

using Kind = Transition::Kind;

namespace {

/// What had to be granted until the column ran and had what the row lost: its chain, what is granted together with
/// that, what pushed, what takes, and what all of these need.
class Awaited {
public:
  Awaited(const Model& model, const Way& way, const Rest& rest) : model_(model), rest_(rest), root_(way.root->edge) {
    reach(way.root->target);
    for (const Link& link : way.links) reach_with_mates(link);
  }

  void add_pusher(EdgeId edge) { reach(model_.edges[edge].target); }

  void add_takers(const std::vector<GroupId>& lost) {
    for (const GroupId each : lost) {
      if (const std::optional<EdgeId> by = rest_.groups[each.value].by) add_chain(model_.edges[*by].requester);
    }
  }

  /// In order.
  const std::set<ProviderId>& providers() const { return providers_; }

private:
  void reach(GroupId group) {
    const std::optional<ProviderId> active = rest_.groups[group.value].active;
    if (!active || !providers_.insert(*active).second) return;
    for (const Use<GroupId>& need : model_.providers[*active].needs) {
      const std::optional<EdgeId> by = rest_.groups[need.id.value].by;
      if (by && model_.edges[*by].requester == group) reach(need.id);
    }
  }

  void reach_with_mates(const Link& link) {
    reach(link.next->target);
    if (!model_.is_usually_member(*link.next)) return;
    for (const Task& task : model_.providers[link.provider].packs[link.pack].tasks) {
      if (model_.is_usually_member(task) && rest_.groups[task.target.value].by == task.edge) reach(task.target);
    }
  }

  /// The group and those that it runs for, if these are the column's.
  void add_chain(std::optional<GroupId> group) {
    if (!group || !rest_.is_under(model_, *group, root_)) return;
    for (std::size_t steps = 0; group && steps <= rest_.groups.size(); ++steps) {
      reach(*group);
      const std::optional<EdgeId> by = rest_.groups[group->value].by;
      group = by ? model_.edges[*by].requester : std::nullopt;
    }
  }

  const Model& model_;
  const Rest& rest_;
  EdgeId root_;
  std::set<ProviderId> providers_;
};

/// The times that one push promises run from the same moment, those of several may run one after another.
std::optional<Microseconds> bound_of(const std::vector<Transition::Push>& pushes) {
  Microseconds sum = 0, longest = 0;
  for (const Transition::Push& push : pushes) {
    if (!push.within) return {};
    if (!push.is_further) sum += std::exchange(longest, 0);
    longest = std::max(longest, *push.within);
  }
  return sum + longest;
}

} // namespace

void Judge::judge(const Beginning& row, const Beginning& column, const Play& now, const Values& change, Transition& out,
                  CellContext& context) const {
  std::vector<GroupId> lost = find_losses(row, column, now.trial, out, context);
  std::vector<GroupId> all = lost;
  all.insert(all.end(), out.again.begin(), out.again.end());
  out.pushes = pushes_of(now.trial, row);
  add_further(row, column, now.trial, change, lost, out.pushes);
  const Parting parting = part(model_, row.way, column.way);
  const bool ended = !runs(now.trial.rest, row.way) || contains(out.again, row.way.target);
  context.withdrawer = parting.link ? model_.groups[row.way.group(*parting.link)].name.value : "The program";
  // What is handed over and pushed does not end by the values, though what requested it does.
  const bool pushed_on = ended && !all.empty() && pushed_first(row, column, now.trial, lost) &&
                         first_pushes(row, now.trial).groups.count(row.way.target.value) != 0;
  if (!pushed_on && (ended || !all.empty()) && player_.ends_by(row, column, change, all)) {
    out.kind = Kind::condition_lost;
    context.row_runs_on = !ended;
  } else if (!pushed_on && parting.replaced && ended &&
             !now.trial.rest.requested[row.way.links[*parting.link].next->edge.value]) {
    out.kind = Kind::replaced;
    context.withdrawn = row.way.links[*parting.link].next->target;
    context.replacement = column.way.links[*parting.link].next->target;
  } else if (all.empty() && (lost = player_.needs_taken(row, now.trial)).empty()) {
    out.kind = Kind::both;
  } else if ((context.ender = find_ender(row, column, now.trial, lost, out, context))) {
    out.kind = Kind::condition_lost;
    context.row_runs_on = !ended;
  } else {
    out.kind = pushed_first(row, column, now.trial, lost) ? Kind::soft : Kind::hard;
    context.takes_over = !lost.empty() && takes_from_side(row, column, now.trial);
    if (context.takes_over) find_all_takers(row, column, now.trial, lost, out, context);
    context.runs_at_once = runs_before(now.trial, row, column);
    if (all.empty()) context.instead = instead_of_needing(row, now.trial.rest, lost);
  }
  if (out.kind != Kind::soft) return;
  out.bound = bound_of(out.pushes);
}

std::vector<ProviderId> Judge::instead_of_needing(const Beginning& row, const Rest& rest,
                                                  const std::vector<GroupId>& taken) const {
  std::vector<ProviderId> out;
  for (const GroupId id : taken) {
    const std::optional<GroupId> needer = model_.edges[*row.rest.groups[id.value].by].requester;
    const std::optional<ProviderId> now = needer ? rest.groups[needer->value].active : std::nullopt;
    if (now && std::find(out.begin(), out.end(), *now) == out.end()) out.push_back(*now);
  }
  return out;
}

/// Whether it is a push, and not for a task that ran on the row's own side and is requested there.
bool Judge::pushes(const Event& event, const Beginning& row) const {
  if (event.kind != Event::Kind::push) return false;
  const EdgeId last = row.way.last().edge;
  const Edge& edge = model_.edges[EdgeId{event.edge}];
  const bool is_requested_there =
      EdgeId{event.edge} == last || (edge.requester && row.rest.is_under(model_, *edge.requester, last));
  return !is_requested_there || !row.rest.is_under(model_, edge.target, last);
}

Judge::Pushed Judge::first_pushes(const Beginning& row, const Trial& trial) const {
  Pushed out;
  for (const Event& event : trial.events) {
    if (!pushes(event, row) || event.micro_step > out.micro_step) continue;
    out.micro_step = event.micro_step;
    out.groups.insert(event.group);
  }
  return out;
}

/// Whether nothing was taken from the row's side before the first push, nor with it, other than what is pushed or,
/// below the row's group, is requested on the column's chain too: that may get another requester at once, and goes on.
/// Of what is lost some is left then.
bool Judge::pushed_first(const Beginning& row, const Beginning& column, const Trial& trial,
                         const std::vector<GroupId>& lost) const {
  const EdgeId edge = row.way.last().edge;
  const auto [first, pushed] = first_pushes(row, trial);
  const auto is_handed_over = [&](const Event& event) {
    if (event.kind != Event::Kind::grant || event.edge >= model_.edges.size()) return false;
    if (GroupId{event.group} == row.way.target && pushed.count(event.group) == 0) return false;
    const Edge& by = model_.edges[EdgeId{event.edge}];
    return by.requester && !by.levels.empty() && column.way.passes(*by.requester);
  };
  const bool any_taken = std::any_of(trial.events.begin(), trial.events.end(), [&](const Event& event) {
    const bool takes = event.kind == Event::Kind::lose || event.kind == Event::Kind::stop ||
                       (event.kind == Event::Kind::grant && event.other != nil && event.other != event.edge);
    if (!takes || is_handed_over(event) || event.micro_step > first ||
        !row.rest.is_under(model_, GroupId{event.group}, edge))
      return false;
    return event.micro_step < first || pushed.count(event.group) == 0;
  });
  if (pushed.empty() || any_taken) return false;
  const Rest with_push = holders_after(row, trial, first);
  return lost.empty() || std::any_of(lost.begin(), lost.end(), [&](GroupId id) {
           return pushed.count(id.value) != 0 || with_push.is_under(model_, id, edge);
         });
}

/// Whether the column was granted when the first push was made.
bool Judge::runs_before(const Trial& trial, const Beginning& row, const Beginning& column) const {
  std::uint64_t granted = 0;
  for (const Event& event : trial.events) {
    if (event.kind == Event::Kind::grant && event.group == column.way.target.value) granted = event.micro_step;
  }
  return granted <= first_pushes(row, trial).micro_step;
}

void Judge::find_all_takers(const Beginning& row, const Beginning& column, const Trial& trial,
                            const std::vector<GroupId>& lost, const Transition& out, CellContext& context) const {
  find_takers(column, trial.rest, lost, context);
  if (out.kind == Kind::hard) find_pushed_takers(row, column, trial, lost, context);
  if (context.takers.empty() && !context.leader) find_takers_below(row, column, trial, lost, context);
}

void Judge::find_takers(const Beginning& column, const Rest& rest, const std::vector<GroupId>& lost,
                        CellContext& context) const {
  std::vector<GroupId> takers;
  std::optional<GroupId> leader;
  bool leader_needs = false;
  const EdgeId edge = column.way.last().edge;
  for (const GroupId id : model_.groups.ids()) {
    const std::optional<ProviderId> active = rest.groups[id.value].active;
    if (!active || std::find(lost.begin(), lost.end(), id) != lost.end()) continue;
    const bool needs = std::any_of(lost.begin(), lost.end(),
                                   [&](GroupId each) { return model_.providers[*active].needs_group(each); });
    const bool requests = std::any_of(lost.begin(), lost.end(), [&](GroupId each) {
      const std::optional<EdgeId> by = rest.groups[each.value].by;
      return by && model_.edges[*by].requester == id;
    });
    if (!needs && !requests) continue;
    if (!rest.is_under(model_, id, column.way.root->edge) || rest.is_under(model_, id, edge)) return;
    if (!column.way.passes(id)) {
      takers.push_back(id);
    } else {
      leader = id;
      leader_needs = leader_needs || needs;
    }
  }
  // What the chain needs, it takes for the column.
  if (takers.empty() && !leader_needs) context.leader = leader;
  context.takers = std::move(takers);
}

void Judge::find_takers_below(const Beginning& row, const Beginning& column, const Trial& trial,
                              const std::vector<GroupId>& lost, CellContext& context) const {
  const auto [when, by] = first_taken(row, column, trial, lost);
  std::vector<GroupId> takers;
  for (const EdgeId edge : by) {
    const std::optional<GroupId> taker = model_.edges[edge].requester;
    const bool is_below = taker && *taker != column.way.target && when.is_under(model_, *taker, column.way.last().edge);
    if (!is_below) return;
    if (!contains(takers, *taker)) takers.push_back(*taker);
  }
  std::sort(takers.begin(), takers.end());
  context.is_below = !takers.empty();
  context.takers = std::move(takers);
}

void Judge::find_pushed_takers(const Beginning& row, const Beginning& column, const Trial& trial,
                               const std::vector<GroupId>& lost, CellContext& context) const {
  const auto [first, pushed] = first_pushes(row, trial);
  if (pushed.empty()) return;
  // Whether it is what the row lost, or may hold that.
  const auto takes = [&](GroupId group) {
    const std::vector<EdgeId>& edges = model_.groups[group].edges;
    return std::any_of(lost.begin(), lost.end(), [&](GroupId each) {
      return each == group ||
             std::any_of(edges.begin(), edges.end(), [&](EdgeId id) { return model_.edges[id].target == each; });
    });
  };
  std::vector<GroupId> takers;
  for (const Event& event : trial.events) {
    if (event.micro_step != first || event.kind != Event::Kind::grant || event.edge >= model_.edges.size()) continue;
    const GroupId group{event.group};
    if (group == column.way.target) return;
    const std::optional<GroupId> requester = model_.edges[EdgeId{event.edge}].requester;
    if (pushed.count(event.group) != 0 && takes(group) && requester && column.way.passes(*requester) &&
        !column.way.passes(group))
      takers.push_back(group);
  }
  if (takers.empty()) return;
  context.takers = std::move(takers);
  context.leader.reset();
}

std::vector<Transition::Push> Judge::pushes_of(const Trial& trial, const Beginning& row) const {
  std::vector<Transition::Push> out;
  for (const Event& event : trial.events) {
    if (!pushes(event, row)) continue;
    Transition::Push push{ProviderId{event.provider}, {}, {}};
    if (event.condition != nil) push.condition = model_.conditions[lowered_.condition_ids[event.condition]].text;
    for (const ConditionUse& use : model_.providers[push.to].causing) {
      if (event.condition != nil && model_.satisfies(use.id, lowered_.condition_ids[event.condition]))
        push.within = use.within;
    }
    const bool known = std::any_of(out.begin(), out.end(), [&](const Transition::Push& each) {
      return each.to == push.to && each.condition == push.condition;
    });
    if (!known) out.push_back(std::move(push));
  }
  return out;
}

void Judge::add_further(const Beginning& row, const Beginning& column, const Trial& trial, const Values& change,
                        const std::vector<GroupId>& lost, std::vector<Transition::Push>& pushes) const {
  if (pushes.empty()) return;
  Values before = change;
  before.insert(row.rest.values.begin(), row.rest.values.end());
  Awaited awaited(model_, column.way, trial.rest);
  awaited.add_takers(lost);
  std::set<ConditionId> served; ///< the promises that were pushed for
  for (const Event& event : trial.events) {
    if (!this->pushes(event, row)) continue;
    awaited.add_pusher(EdgeId{event.edge});
    for (const ConditionUse& use : model_.providers[ProviderId{event.provider}].causing) {
      if (event.condition != nil && model_.satisfies(use.id, lowered_.condition_ids[event.condition]))
        served.insert(use.id);
    }
  }
  std::set<ProviderId> waiters = awaited.providers();
  for (const Transition::Push& push : pushes) waiters.insert(push.to);
  // What was false before, and no push was made for it.
  std::set<ConditionId> lacking;
  for (const ProviderId id : waiters) {
    for (const ConditionUse& use : model_.providers[id].when) {
      const Condition& condition = model_.conditions[use.id];
      const auto value = before.find(condition.state);
      const bool holds = value != before.end() && condition.accepts.contains(value->second);
      const bool is_served = std::any_of(served.begin(), served.end(),
                                         [&](ConditionId promise) { return model_.satisfies(promise, use.id); });
      if (!holds && !is_served && !model_.causes(id, use.id)) lacking.insert(use.id);
    }
  }
  std::vector<Transition::Push> out;
  for (Transition::Push& push : pushes) {
    const ProviderId to = push.to;
    out.push_back(std::move(push));
    for (const ConditionUse& use : model_.providers[to].causing) {
      const auto waited_for =
          std::find_if(lacking.begin(), lacking.end(), [&](ConditionId id) { return model_.satisfies(use.id, id); });
      if (waited_for == lacking.end()) continue;
      out.push_back({to, model_.conditions[*waited_for].text, use.within, true});
      std::erase_if(lacking, [&](ConditionId id) { return model_.satisfies(use.id, id); });
    }
  }
  pushes = std::move(out);
}

} // namespace director::compiler::transitions
