// Header: compiler/lower/steps.hpp. Test: tests/compiler/lower/lower_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/graph/components.hpp"
#include "compiler/lower/steps.hpp"

#include <algorithm>

namespace director::compiler {

namespace {

void sort_once(std::vector<Index>& rows) {
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
}

/// In a Lowered whose lists grow meanwhile.
std::vector<Index> listed(const Lowered& out, Range range) {
  return {out.lists.begin() + range.begin, out.lists.begin() + range.end};
}

} // namespace

void lower_components(const Model& model, Lowered& out) {
  const auto wanted = [&](const director::Provider& provider) {
    std::vector<Index> conditions = listed(out, provider.when);
    const std::vector<Index> stay = listed(out, provider.stay);
    conditions.insert(conditions.end(), stay.begin(), stay.end());
    return conditions;
  };
  struct Rows {
    std::vector<Index> groups, edges;
  };
  std::vector<Rows> rows;
  const IdTable<GroupId, std::uint32_t> found = find_components(model);
  for (const GroupId group : model.groups.ids()) {
    const auto component = static_cast<Index>(found[group]);
    if (component == rows.size()) rows.emplace_back();
    out.groups[row(group)].component = component;
    rows[component].groups.push_back(row(group));
  }
  const auto of = [&](Index group) -> Rows& { return rows[out.groups[group].component]; };
  for (Index e = 0; e < out.edges.size(); ++e) of(out.edges[e].target).edges.push_back(e);
  std::vector<std::vector<Index>> counts_in(out.conditions.size());
  for (Index p = 0; p < out.providers.size(); ++p) {
    const director::Provider& provider = out.providers[p];
    const Index component = out.groups[provider.group].component;
    for (const Index condition : wanted(provider)) counts_in[condition].push_back(component);
    for (Index i = provider.promises.begin; i != provider.promises.end; ++i)
      counts_in[out.promises[i].condition].push_back(component);
  }

  Index order = 0;
  for (const Rows& row : rows) {
    director::Component component;
    component.groups = add_list(out, row.groups);
    component.edges = add_list(out, row.edges);
    component.order = order;
    order = static_cast<Index>(order + row.groups.size());
    out.components.push_back(component);
  }
  std::vector<std::vector<Index>> on_state(out.states.size());
  for (Index c = 0; c < out.conditions.size(); ++c) {
    sort_once(counts_in[c]);
    on_state[out.conditions[c].state].push_back(c);
  }
  for (Index s = 0; s < out.states.size(); ++s) { // what is read together is adjacent
    out.states[s].conditions = add_list(out, on_state[s]);
    for (const Index c : on_state[s]) out.conditions[c].components = add_list(out, counts_in[c]);
  }
}

} // namespace director::compiler
