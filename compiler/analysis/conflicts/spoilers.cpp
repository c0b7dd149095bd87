// Header: compiler/analysis/conflicts/spoilers.hpp. Test: compiler/checks/starved_task.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/spoilers.hpp"

#include "compiler/analysis/shared/shared.hpp"

#include <algorithm>
#include <iterator>

namespace director::analysis {

namespace {

/// Limit for the groups for which other requesters are searched; of more, all may have some.
constexpr std::size_t most_inside = 2'000;

} // namespace

Spoilers::Spoilers(const Input& input, const Takers& takers, const Beside& beside)
    : input_(input),
      takers_(takers),
      requester_(beside.requester),
      by_(beside.by->target),
      over_(beside.over->target) {
  for (const Task* member : *beside.unit) own_.insert(member->target);
  find_after(beside);
  is_before_below_ = beside.is_before_below;
  goes_before_over_ = is_before_below_ || own_.count(over_) != 0 || after_.count(over_) != 0;
  find_inside();
  find_early();
}

Groups Spoilers::of(const Groups& taken) const {
  Groups out;
  std::copy_if(taken.begin(), taken.end(), std::back_inserter(out), [&](GroupId group) {
    const std::vector<EdgeId>& all = input_.model.groups[group].requesters;
    return std::any_of(all.begin(), all.end(),
                       [&](EdgeId id) { return takers_.is_alive(id) && may_hold(input_.model.edges[id]); });
  });
  return out;
}

void Spoilers::find_after(const Beside& beside) {
  std::set<GroupId> others;
  for (const ProviderId id : input_.model.groups[requester_].providers) {
    for (const Pack& pack : input_.model.providers[id].packs) {
      const auto is_after = [&](const Task& task) {
        return takers_.always_before(*beside.by, task) ||
               (&task == beside.over && takers_.always_first_of_equals(requester_, *beside.by, task));
      };
      // A unit is tried at the place of its first member.
      const Unit unit = unit_members(input_.model, pack);
      const bool is_unit_after =
          std::all_of(unit.begin(), unit.end(), [&](const Task* each) { return is_after(*each); });
      for (const Task& task : pack.tasks) {
        const bool goes_after = is_after(task) && (is_unit_after || !takers_.is_member(task));
        (goes_after ? after_ : others).insert(task.target);
      }
    }
  }
  for (const GroupId group : others) after_.erase(group);
  for (const GroupId group : own_) after_.erase(group);
}

void Spoilers::find_inside() {
  std::set<GroupId> below;
  const auto add = [&](GroupId branch) {
    if (below.size() > most_inside) return;
    const Groups& groups = input_.shared.claims(branch).groups();
    below.insert(groups.begin(), groups.end());
  };
  std::for_each(own_.begin(), own_.end(), add);
  std::for_each(after_.begin(), after_.end(), add);
  add(over_);
  below.erase(requester_);
  if (below.size() > most_inside) return;
  const auto is_inside = [&](GroupId group) {
    const std::vector<EdgeId>& all = input_.model.groups[group].requesters;
    return std::all_of(all.begin(), all.end(), [&](EdgeId id) {
      const std::optional<GroupId> by = input_.model.edges[id].requester;
      return !takers_.is_alive(id) || (by && (*by == requester_ ? is_branch(group) : below.count(*by) != 0));
    });
  };
  Groups open(below.begin(), below.end());
  while (!open.empty()) {
    const GroupId group = open.back();
    open.pop_back();
    if (below.count(group) == 0 || is_inside(group)) continue;
    below.erase(group);
    for (const EdgeId id : input_.model.groups[group].edges) open.push_back(input_.model.edges[id].target);
  }
  inside_.assign(below.begin(), below.end());
}

void Spoilers::find_early() {
  for (const EdgeId id : input_.model.groups[requester_].edges) {
    const Edge& edge = input_.model.edges[id];
    if (!edge.needed || edge.target == by_) continue;
    const Groups& needed = input_.shared.units().needed(edge.target);
    early_.insert(needed.begin(), needed.end());
  }
}

bool Spoilers::may_hold(const Edge& edge) const {
  if (!edge.requester) return true;
  if (*edge.requester == requester_)
    return own_.count(edge.target) == 0 && (edge.needed || after_.count(edge.target) == 0);
  if (!has(inside_, *edge.requester)) return true;
  if (edge.needed && early_.count(*edge.requester) != 0) return true;
  if (is_before_below_ && edge.needed && has(input_.shared.units().needed(over_), *edge.requester)) return true;
  if (goes_before_over_ || !has(input_.shared.claims(over_).groups(), *edge.requester)) return false;
  return edge.needed || edge.has_mandatory();
}

} // namespace director::analysis
