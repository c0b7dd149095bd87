// Header: compiler/analysis/causing/imprecise.hpp. Test: compiler/checks/imprecise_causing.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/imprecise.hpp"

#include "compiler/analysis/facts/pushes.hpp"
#include "compiler/analysis/facts/waiting.hpp"

#include <algorithm>

namespace director::analysis {

std::vector<Imprecise> find_imprecise(const Model& model, const Causers& causers, const Facts& facts,
                                      const Chains& chains) {
  IdTable<StateId, std::vector<std::pair<ProviderId, ConditionUse>>> promises(model.states.size());
  for (const ProviderId causer : model.providers.ids()) {
    for (const ConditionUse& use : model.providers[causer].causing)
      promises[model.conditions[use.id].state].emplace_back(causer, use);
  }
  // A task also waits for the conditions of its needs.
  Waiting waiting(model, facts);
  IdTable<ProviderId, std::vector<GroupId>> tasks(model.providers.size());
  for (const GroupId group : model.groups.ids()) {
    if (!facts.requested.contains(group) || !waiting.may_wait(group)) continue;
    for (const auto& [provider, use] : waited_conditions(model, facts, group)) {
      if (waiting.may_be_first(provider) && (tasks[provider].empty() || tasks[provider].back() != group))
        tasks[provider].push_back(group);
    }
  }
  std::vector<Imprecise> out;
  for (const ProviderId waiter : model.providers.ids()) {
    const GroupId group = model.providers[waiter].group;
    for (const ConditionUse& condition : model.providers[waiter].when) {
      const Condition& wanted = model.conditions[condition.id];
      if (tasks[waiter].empty() || !causers[condition.id].empty()) continue;
      for (const auto& [causer, promise] : promises[wanted.state]) {
        const GroupId other = model.providers[causer].group;
        if (other == group) continue;
        if (!model.conditions[promise.id].accepts.overlaps(wanted.accepts)) continue;
        const bool may_push = std::any_of(tasks[waiter].begin(), tasks[waiter].end(),
                                          [&](GroupId task) { return task != other && chains.may_beat(task, other); });
        if (may_push) out.push_back({waiter, condition, causer, promise});
      }
    }
  }
  return out;
}

} // namespace director::analysis
