// Header: compiler/transitions/judge.hpp. Test: tests/compiler/transitions/again_test.cpp.
// SPDX-License-Identifier: MIT
//
// What the row's side loses: by a condition, or to others.
#include "compiler/transitions/judge.hpp"

#include <algorithm>

namespace director::compiler::transitions {

namespace {

void set_holder(const Event& event, Rest& rest) {
  if (event.kind != Event::Kind::lose && event.kind != Event::Kind::grant) return;
  rest.groups[event.group].by.reset();
  if (event.edge < rest.running.size()) rest.groups[event.group].by = EdgeId{event.edge}; // else: lost, or limbo
}

/// The request at which the chain of the row leaves that of the column.
EdgeId side_of(const Beginning& row, const Parting& parting) {
  return parting.link ? row.way.links[*parting.link].next->edge : row.way.root->edge;
}

} // namespace

std::vector<GroupId> Judge::find_losses(const Beginning& row, const Beginning& column, const Trial& trial,
                                        Transition& out, CellContext& context) const {
  std::vector<GroupId> lost = player_.lost(row, trial.rest);
  out.again = player_.interrupted(row, trial);
  out.stops.clear(), out.taken.clear();
  context.left.clear(), context.above.clear();
  context.holder.reset();
  for (const GroupId id : lost) {
    if (!row.rest.groups[id.value].granted || contains(out.again, id)) continue;
    (trial.rest.groups[id.value].granted ? out.taken : out.stops).push_back(id);
  }
  context.others = out.taken;
  for (const GroupId id : out.again) {
    if (contains(lost, id)) context.others.push_back(id);
  }
  for (const GroupId id : context.others) {
    if (!trial.rest.is_for(model_, id, row.way.target)) context.left.push_back(id);
  }
  find_above(row, part(model_, row.way, column.way), trial, out, context);
  return lost;
}

void Judge::find_above(const Beginning& row, const Parting& parting, const Trial& trial, Transition& out,
                       CellContext& context) const {
  const Rest& rest = trial.rest;
  const std::size_t first = parting.link ? *parting.link + 1 : 0;
  std::vector<GroupId> chain;
  for (std::size_t i = first; i < row.way.links.size(); ++i) chain.push_back(row.way.group(i));
  for (const GroupId id : chain) {
    if (!row.rest.groups[id.value].granted || contains(out.stops, id) || contains(out.again, id)) continue;
    const bool runs_now = rest.groups[id.value].granted;
    if (runs_now && !has_stopped(trial, id)) continue;
    if (!runs_now)
      context.above.push_back(id);
    else
      out.again.push_back(id);
  }
  std::sort(out.again.begin(), out.again.end());
  out.stops.insert(out.stops.end(), context.above.begin(), context.above.end());
  std::sort(out.stops.begin(), out.stops.end());
  if (context.above.empty()) return;
  const EdgeId side = side_of(row, parting);
  std::optional<std::size_t> deepest;
  for (const GroupId id : model_.groups.ids()) {
    const bool is_taken =
        row.rest.is_under(model_, id, side) && rest.groups[id.value].by && !rest.is_under(model_, id, side);
    if (!is_taken) continue;
    if (row.rest.is_under(model_, id, row.way.last().edge)) return;
    for (std::size_t i = chain.size(); i-- > deepest.value_or(0);) {
      if (!row.rest.is_for(model_, id, chain[i])) continue;
      deepest = i;
      break;
    }
  }
  if (deepest) context.holder = chain[*deepest];
}

Rest Judge::holders_after(const Beginning& row, const Trial& trial, std::uint64_t micro_step) {
  Rest out = row.rest;
  for (const Event& event : trial.events) {
    if (event.micro_step <= micro_step) set_holder(event, out);
  }
  return out;
}

Judge::Taken Judge::first_taken(const Beginning& row, const Beginning& column, const Trial& trial,
                                const std::vector<GroupId>& groups) const {
  const EdgeId side = side_of(row, part(model_, row.way, column.way));
  Taken out{row.rest, {}};
  for (auto at = trial.events.begin(); at != trial.events.end() && out.by.empty();) {
    const std::uint64_t micro_step = at->micro_step;
    for (; at != trial.events.end() && at->micro_step == micro_step; ++at) set_holder(*at, out.when);
    for (const GroupId id : groups) {
      std::optional<EdgeId> by = out.when.groups[id.value].by;
      if (!by || out.when.is_under(model_, id, side)) continue;
      // What was taken with it: the request from elsewhere is above that.
      std::optional<GroupId> above = model_.edges[*by].requester;
      for (std::size_t steps = 0; above && row.rest.is_under(model_, *above, side) && steps < groups.size(); ++steps) {
        if (!out.when.groups[above->value].by) break;
        by = out.when.groups[above->value].by;
        above = model_.edges[*by].requester;
      }
      out.by.push_back(*by);
    }
  }
  return out;
}

bool Judge::takes_from_side(const Beginning& row, const Beginning& column, const Trial& trial) const {
  const EdgeId side = side_of(row, part(model_, row.way, column.way));
  std::vector<GroupId> groups;
  for (const GroupId id : model_.groups.ids()) {
    if (row.rest.is_under(model_, id, side)) groups.push_back(id);
  }
  return !first_taken(row, column, trial, groups).by.empty();
}

std::optional<SetState> Judge::find_ender(const Beginning& row, const Beginning& column, const Trial& trial,
                                          const std::vector<GroupId>& lost, const Transition& out,
                                          const CellContext& context) const {
  const bool is_any_held =
      std::any_of(lost.begin(), lost.end(), [&](GroupId id) { return trial.rest.groups[id.value].by.has_value(); });
  if (is_any_held || context.holder || !out.pushes.empty()) return {};
  if (!first_taken(row, column, trial, out.again).by.empty()) return {};
  // What only stopped and runs again stopped by what was set before.
  const auto first_stop = std::find_if(trial.events.begin(), trial.events.end(), [&](const Event& event) {
    return lost.empty() && event.kind == Event::Kind::stop && contains(out.again, GroupId{event.group});
  });
  const auto ends = [&](const SetState& set, const ConditionUse& use) {
    const Condition& condition = model_.conditions[use.id];
    if (condition.state != set.state || condition.accepts.contains(set.value)) return false;
    const auto before = row.rest.values.find(set.state), after = trial.rest.values.find(set.state);
    return before != row.rest.values.end() && condition.accepts.contains(before->second) &&
           (lost.empty() || (after != trial.rest.values.end() && after->second == set.value));
  };
  for (const SetState& set : set_states_of({trial.events.begin(), first_stop})) {
    for (const GroupId id : model_.groups.ids()) {
      const std::optional<ProviderId> ran = row.rest.groups[id.value].active;
      if (!ran || !(row.way.passes(id) || row.rest.is_under(model_, id, row.way.last().edge))) continue;
      const std::vector<ConditionUse>& when = model_.providers[*ran].when;
      if (std::any_of(when.begin(), when.end(), [&](const ConditionUse& use) { return ends(set, use); })) return set;
    }
  }
  return {};
}

} // namespace director::compiler::transitions
