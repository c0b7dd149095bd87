// Header: compiler/analysis/needs/needs.hpp. Test: tests/compiler/analysis/needs/needs_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/needs/needs.hpp"

#include <algorithm>
#include <unordered_map>

namespace director::analysis {

namespace {

/// Groups that can be granted if a group may serve any number of needs, `without` this one: their needs end somewhere.
IdSet<GroupId> find_ending(const Model& model, std::optional<GroupId> without) {
  IdSet<GroupId> ending(model.groups.size());
  IdTable<ProviderId, std::size_t> missing(model.providers.size());
  IdTable<GroupId, std::vector<ProviderId>> needers(model.groups.size());
  std::vector<GroupId> open;
  const auto add = [&](GroupId group) {
    if (group != without && ending.add(group)) open.push_back(group);
  };
  for (const ProviderId id : model.providers.ids()) {
    const Provider& provider = model.providers[id];
    missing[id] = provider.needs.size();
    for (const Use<GroupId>& need : provider.needs) needers[need.id].push_back(id);
    if (provider.needs.empty()) add(provider.group);
  }
  while (!open.empty()) {
    const GroupId group = open.back();
    open.pop_back();
    for (const ProviderId id : needers[group]) {
      if (--missing[id] == 0) add(model.providers[id].group);
    }
  }
  return ending;
}

ChainStep step_between(const Model& model, GroupId from, GroupId to) {
  for (const ProviderId provider : model.groups[from].providers) {
    for (const Use<GroupId>& need : model.providers[provider].needs) {
      if (need.id == to) return {from, to, true, need.span};
    }
  }
  return {from, to, true, model.groups[from].name.span};
}

std::vector<ChainStep> steps_along(const Model& model, const std::vector<Node>& path) {
  std::vector<ChainStep> out;
  for (std::size_t i = 1; i < path.size(); ++i)
    out.push_back(step_between(model, GroupId{path[i - 1]}, GroupId{path[i]}));
  return out;
}

/// Cycles in which every provider of every group needs another group of the cycle.
std::vector<std::vector<ChainStep>> cycles_of_groups(const Model& model, const Graph& graph) {
  const IdSet<GroupId> ending = find_ending(model, std::nullopt);
  Arrows stuck = graph.needs;
  for (const GroupId group : model.groups.ids()) {
    std::vector<Node>& row = stuck[group.value];
    const auto leads_out = [&](Node to) { return ending.contains(group) || ending.contains(GroupId{to}); };
    row.erase(std::remove_if(row.begin(), row.end(), leads_out), row.end());
  }
  std::vector<std::vector<ChainStep>> out;
  for (const std::vector<Node>& nodes : cycles(stuck))
    out.push_back(steps_along(model, shortest_path(stuck, nodes[0], nodes[0])));
  return out;
}

/// The first need of a provider that cannot be granted without the provider's own group.
const Use<GroupId>* find_need_of_itself(const Model& model, ProviderId id) {
  const Provider& provider = model.providers[id];
  const IdSet<GroupId> ending = find_ending(model, provider.group);
  for (const Use<GroupId>& need : provider.needs) {
    if (!ending.contains(need.id)) return &need;
  }
  return nullptr;
}

/// Providers without a plan whose needs end somewhere, and that would have none even if all others had one.
std::vector<ProviderId> find_faulty(const Model& model, const Facts& facts, Budget& budget) {
  std::vector<ProviderId> out;
  IdSet<ProviderId> planless(model.providers.size());
  for (const ProviderId id : model.providers.ids()) {
    if (facts.plans[id] != PlanVerdict::found) planless.add(id);
  }
  const IdSet<GroupId> ending = find_ending(model, std::nullopt);
  for (const ProviderId id : model.providers.ids()) {
    const Provider& provider = model.providers[id];
    const bool ends = std::all_of(provider.needs.begin(), provider.needs.end(),
                                  [&](const Use<GroupId>& need) { return ending.contains(need.id); });
    if (!planless.contains(id) || !ends) continue;
    IdSet<ProviderId> mended = planless; // the search ignores this for its own needs
    if (find_plan(model, id, budget, &mended) != PlanVerdict::found) out.push_back(id);
  }
  return out;
}

} // namespace

std::vector<std::vector<ChainStep>> find_need_cycles(const Model& model, const Graph& graph, const Facts& facts,
                                                     Budget& budget) {
  std::vector<std::vector<ChainStep>> out = cycles_of_groups(model, graph);
  for (const ProviderId id : find_faulty(model, facts, budget)) {
    const Use<GroupId>* need = find_need_of_itself(model, id);
    if (need == nullptr) continue;
    const GroupId group = model.providers[id].group;
    std::vector<ChainStep> cycle{{group, need->id, true, need->span}};
    for (const ChainStep& step : need_path(model, need->id, group)) cycle.push_back(step);
    out.push_back(std::move(cycle));
  }
  return out;
}

std::vector<ProviderId> find_need_conflicts(const Model& model, const Facts& facts, Budget& budget) {
  std::vector<ProviderId> out;
  for (const ProviderId id : find_faulty(model, facts, budget)) {
    if (find_need_of_itself(model, id) == nullptr) out.push_back(id);
  }
  return out;
}

std::vector<ChainStep> need_path(const Model& model, GroupId from, GroupId to) {
  if (from == to) return {};
  // Called once for each finding, so it searches no more than necessary.
  std::unordered_map<GroupId, GroupId> above;
  std::vector<GroupId> open{from};
  for (std::size_t next = 0; next < open.size() && above.count(to) == 0; ++next) {
    for (const EdgeId id : model.groups[open[next]].edges) {
      const Edge& edge = model.edges[id];
      if (edge.needed && edge.target != from && above.try_emplace(edge.target, open[next]).second)
        open.push_back(edge.target);
    }
  }
  if (above.count(to) == 0) return {};
  std::vector<ChainStep> out;
  for (GroupId group = to; group != from; group = above[group]) out.push_back(step_between(model, above[group], group));
  std::reverse(out.begin(), out.end());
  return out;
}

} // namespace director::analysis
