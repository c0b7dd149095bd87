// Header: compiler/analysis/requests/requests.hpp. Test: tests/compiler/analysis/requests/requests_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/requests/requests.hpp"

namespace director::analysis {

Requests::Requests(const Model& model, const Graph& graph, const Facts& facts)
    : model_(model),
      ways_(model, facts, true, [](ProviderId, const ConditionUse&) { return true; }),
      requests_(model.groups.size()),
      regions_(model.groups.size()) {
  for (const Task& task : model.roots) requests_[task.target].push_back({std::nullopt, nullptr, &task});
  for (const ProviderId id : model.providers.ids()) {
    if (!facts.active.contains(id)) continue;
    for (const Pack& pack : model.providers[id].packs) {
      for (const Task& task : pack.tasks) requests_[task.target].push_back({id, &pack, &task});
    }
  }
  // Requesters come first; if a cycle prevents that, an unknown region is open.
  for (const Node node : graph.order) {
    const GroupId group{node};
    std::optional<Region> out;
    for (const Request& request : requests_[group]) {
      for (const Region& region : regions(request)) out = out ? hull(*out, region) : region;
    }
    regions_[group] = out.value_or(Region{});
  }
}

std::vector<Region> Requests::regions(const Request& request) const {
  if (!request.requester) return {Region{}};
  std::vector<Region> out;
  for (Region region : ways_.of(*request.requester)) {
    region.meet(regions_[model_.providers[*request.requester].group]);
    if (!region.empty()) out.push_back(std::move(region));
  }
  return out;
}

} // namespace director::analysis
