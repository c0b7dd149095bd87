// Header: tests/oracle/behaviour.hpp. Test: tests/oracle/conformance_test.cpp.
// SPDX-License-Identifier: MIT
// semantics.md, section 5: acting on the difference.
#include "tests/oracle/behaviour.hpp"

#include <algorithm>

namespace director::oracle {

void Behaviour::act(const Assignment& before) {
  const Model& model = parts_.model();
  std::map<StateId, std::int64_t> handlers_set; // the last call wins
  // 1. Stop.
  for (const GroupId group : before.order) {
    if (before.active[group] && !now_.active[group]) stop(group, handlers_set);
  }
  // 2. In the new order.
  for (const GroupId group : now_.order) {
    if (!now_.granted(group)) continue;
    const std::set<Reason> reasons = news(before, group);
    data_[group] = facts_.request[now_.held[group]->by]->data;
    if (!before.active[group] && model.groups[group].start) {
      trace_.push_back("start " + model.groups[group].name.value);
      for (const auto& [state, value] : bodies_.start(group, data_[group])) handlers_set[state] = value;
    }
    if (before.active[group] != now_.active[group]) {
      const auto& every = model.providers[*now_.active[group]].every;
      every_[group] = every ? std::optional(time_ + *every) : std::nullopt;
    }
    if (reasons.contains(Reason::new_task)) done_[group] = Done::no;
    facts_.pending[group].insert(reasons.begin(), reasons.end());
    if (!facts_.pending[group].empty() && std::find(queue_.begin(), queue_.end(), group) == queue_.end())
      queue_.push_back(group);
  }
  std::erase_if(queue_, [&](GroupId group) { return !now_.granted(group); });
  if (!handlers_set.empty()) handlers_set_ = Settings(handlers_set.begin(), handlers_set.end());
}

std::set<Reason> Behaviour::news(const Assignment& before, GroupId group) const {
  std::set<Reason> reasons;
  const EdgeId holder = now_.held[group]->by;
  if (!before.active[group] || !before.granted_to(holder, group) || facts_.anew.contains(holder))
    reasons.insert(Reason::new_task);
  const bool in_force = now_.in_force.contains(group);
  if (before.active[group] != now_.active[group]) reasons.insert(in_force ? Reason::pushed : Reason::new_task);
  const auto serves = now_.serving.find(group);
  const auto served = before.serving.find(group);
  if (serves != now_.serving.end() && (served == before.serving.end() || served->second != serves->second))
    reasons.insert(Reason::pushed);
  return reasons;
}

// A group that is held as a need stays held.
void Behaviour::stop(GroupId group, std::map<StateId, std::int64_t>& handlers_set) {
  const compiler::Group& words = parts_.model().groups[group];
  for (const StateId state : parts_.model().states.ids()) {
    const auto& owner = parts_.model().states[state].of;
    if (owner && owner->id == group) handlers_set[state] = *parts_.model().states[state].initial;
  }
  if (words.stop) {
    trace_.push_back("stop " + words.name.value);
    for (const auto& [state, value] : bodies_.stop(group, data_[group])) handlers_set[state] = value;
  }
  done_[group] = Done::no;
  facts_.pending[group].clear();
  fired_[group].clear();
  wait_[group].reset();
  every_[group].reset();
  for (const EdgeId edge : words.edges) facts_.request[edge].reset();
}

} // namespace director::oracle
