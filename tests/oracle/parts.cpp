// Header: tests/oracle/parts.hpp. Test: tests/oracle/parts_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/oracle/parts.hpp"

#include <algorithm>

namespace director::oracle {

namespace {

EdgeId edge_between(const Model& model, GroupId from, GroupId to) {
  const std::vector<EdgeId>& edges = model.groups[from].edges;
  return *std::find_if(edges.begin(), edges.end(), [&](EdgeId e) { return model.edges[e].target == to; });
}

/// A need that is not met yet.
struct Open {
  GroupId needer{}, group{};
};

/// Meets the first open need in every way, with the needs of that way before the other open ones.
void meet(const Model& model, GroupId own, const std::vector<Open>& open, const Plan& plan, std::vector<Plan>& out) {
  if (open.empty()) {
    out.push_back(plan);
    return;
  }
  const Open need = open.front();
  const bool twice = need.group == own || std::any_of(plan.begin(), plan.end(), [&](const PlanEntry& entry) {
                       return entry.group == need.group;
                     });
  if (twice) return; // a group cannot be held for two needs
  for (const ProviderId provider : model.groups[need.group].providers) {
    Plan longer = plan;
    longer.push_back({need.group, provider, need.needer, edge_between(model, need.needer, need.group)});
    std::vector<Open> still;
    for (const auto& deeper : model.providers[provider].needs) still.push_back({need.group, deeper.id});
    still.insert(still.end(), open.begin() + 1, open.end());
    meet(model, own, still, longer, out);
  }
}

} // namespace

Parts::Parts(const Model& model) : model_(model), plans_(model.providers.size()), reach_(model.groups.size()) {
  for (const ProviderId p : model.providers.ids()) {
    std::vector<Open> open;
    for (const auto& need : model.providers[p].needs) open.push_back({group_of(p), need.id});
    meet(model, group_of(p), open, {}, plans_[p]);
  }
  for (const GroupId g : model.groups.ids()) {
    std::vector<GroupId> found{g};
    while (!found.empty()) {
      const GroupId at = found.back();
      found.pop_back();
      for (const EdgeId e : model.groups[at].edges) {
        if (reach_[g].insert(target(e)).second) found.push_back(target(e));
      }
    }
  }
}

bool Parts::satisfies(ConditionId causing, ConditionId when) const {
  const compiler::Condition& c = model_.conditions[causing];
  const compiler::Condition& w = model_.conditions[when];
  return c.state == w.state && !c.accepts.empty() && c.accepts.subset_of(w.accepts);
}

bool Parts::causes(ProviderId provider, ConditionId when) const {
  const auto& causing = model_.providers[provider].causing;
  return std::any_of(causing.begin(), causing.end(), [&](const auto& use) { return satisfies(use.id, when); });
}

bool Parts::causes_state(ProviderId provider, StateId state) const {
  const auto& causing = model_.providers[provider].causing;
  return std::any_of(causing.begin(), causing.end(),
                     [&](const auto& use) { return model_.conditions[use.id].state == state; });
}

EdgeId Parts::limbo(GroupId group) const {
  return EdgeId{static_cast<std::uint32_t>(model_.edges.size() + group.value)};
}

std::optional<GroupId> Parts::requester(EdgeId edge) const {
  return is_limbo(edge) ? std::nullopt : model_.edges[edge].requester;
}

GroupId Parts::target(EdgeId edge) const {
  if (is_limbo(edge)) return GroupId{static_cast<std::uint32_t>(edge.value - model_.edges.size())};
  return model_.edges[edge].target;
}

std::string Parts::name(EdgeId edge) const {
  return is_limbo(edge) ? "limbo>" + model_.groups[target(edge)].name.value : model_.edge_name(edge);
}

} // namespace director::oracle
