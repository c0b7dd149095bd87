// Header: compiler/analysis/facts/concerned.hpp. Test: tests/compiler/analysis/facts/facts_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/concerned.hpp"

namespace director::analysis {

Concerned find_concerned(const Model& model, const Graph& graph, const IdTable<StateId, std::vector<Source>>& sources) {
  const std::size_t groups = model.groups.size();
  Concerned out;
  out.needers = IdTable<GroupId, std::vector<GroupId>>(groups);
  out.waiters = IdTable<StateId, std::vector<GroupId>>(model.states.size());
  out.set_by_provider = IdTable<ProviderId, Concerned::Sets>(model.providers.size());
  out.set_by_handlers = IdTable<GroupId, Concerned::Sets>(groups);
  out.place = IdTable<GroupId, std::size_t>(groups);
  for (const GroupId group : model.groups.ids()) {
    for (const ProviderId id : model.groups[group].providers) {
      for (const Use<GroupId>& need : model.providers[id].needs) out.needers[need.id].push_back(group);
      for (const ConditionUse& use : model.providers[id].when) {
        std::vector<GroupId>& waiters = out.waiters[model.conditions[use.id].state];
        if (waiters.empty() || waiters.back() != group) waiters.push_back(group);
      }
    }
  }
  for (const StateId state : model.states.ids()) {
    for (const Source& source : sources[state]) {
      if (source.provider) out.set_by_provider[*source.provider].emplace_back(state, &source);
      if (source.group) out.set_by_handlers[*source.group].emplace_back(state, &source);
    }
  }
  for (std::size_t place = 0; place < graph.order.size(); ++place) out.place[GroupId{graph.order[place]}] = place;
  return out;
}

IdSet<GroupId> find_waiting(const Model& model, const Concerned& concerned) {
  IdSet<GroupId> out(model.groups.size());
  std::vector<GroupId> open;
  for (const Provider& provider : model.providers) {
    if (!provider.when.empty()) open.push_back(provider.group);
  }
  while (!open.empty()) {
    const GroupId group = open.back();
    open.pop_back();
    if (out.add(group)) open.insert(open.end(), concerned.needers[group].begin(), concerned.needers[group].end());
  }
  return out;
}

} // namespace director::analysis
