// Header: compiler/analysis/causing/imprecise.hpp. Test: compiler/checks/imprecise_causing.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/imprecise.hpp"

#include "compiler/analysis/facts/pushes.hpp"

namespace director::analysis {

std::vector<Imprecise> find_imprecise(const Model& model, const Causers& causers, const Facts& facts) {
  IdTable<StateId, std::vector<std::pair<ProviderId, ConditionUse>>> promises(model.states.size());
  for (const ProviderId causer : model.providers.ids()) {
    for (const ConditionUse& use : model.providers[causer].causing)
      promises[model.conditions[use.id].state].emplace_back(causer, use);
  }
  // A task also waits for the conditions of its needs.
  IdSet<ProviderId> waiters(model.providers.size());
  for (const GroupId group : model.groups.ids()) {
    if (!facts.requested.contains(group)) continue;
    for (const auto& [provider, use] : waited_conditions(model, facts, group)) waiters.add(provider);
  }
  std::vector<Imprecise> out;
  for (const ProviderId waiter : model.providers.ids()) {
    const GroupId group = model.providers[waiter].group;
    if (!waiters.contains(waiter)) continue;
    for (const ConditionUse& condition : model.providers[waiter].when) {
      const Condition& wanted = model.conditions[condition.id];
      if (!causers[condition.id].empty()) continue;
      for (const auto& [causer, promise] : promises[wanted.state]) {
        if (model.providers[causer].group == group) continue;
        if (model.conditions[promise.id].accepts.intersected(wanted.accepts).empty()) continue;
        out.push_back({waiter, condition, causer, promise});
      }
    }
  }
  return out;
}

} // namespace director::analysis
