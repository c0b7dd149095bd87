// Header: compiler/lower/steps.hpp. Test: tests/compiler/lower/lower_test.cpp.
// SPDX-License-Identifier: MIT
//
// Components: the parts of a specification that are decided independently. Union-find over everything that can join two
// groups: a request or need, and a causing provider that satisfies a condition of the other.

#include "compiler/lower/steps.hpp"

#include <algorithm>
#include <numeric>

namespace director::compiler {

namespace {

class Joined {
public:
  explicit Joined(std::size_t count) : above_(count) { std::iota(above_.begin(), above_.end(), Index{0}); }
  Index find(Index at) {
    while (above_[at] != at) at = above_[at] = above_[above_[at]];
    return at;
  }
  void join(Index a, Index b) {
    a = find(a), b = find(b);
    above_[std::max(a, b)] = std::min(a, b); // the representative is the group declared first
  }

private:
  std::vector<Index> above_;
};

void sort_once(std::vector<Index>& rows) {
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
}

/// In a Lowered whose lists grow meanwhile.
std::vector<Index> listed(const Lowered& out, Range range) {
  return {out.lists.begin() + range.begin, out.lists.begin() + range.end};
}

} // namespace

void lower_components(Lowered& out) {
  Joined joined(out.groups.size());
  for (const director::Edge& edge : out.edges) {
    if (edge.requester != nil) joined.join(edge.requester, edge.target);
  }
  const auto wanted = [&](const director::Provider& provider) {
    std::vector<Index> conditions = listed(out, provider.when);
    const std::vector<Index> stay = listed(out, provider.stay);
    conditions.insert(conditions.end(), stay.begin(), stay.end());
    return conditions;
  };
  for (const director::Provider& provider : out.providers) {
    for (const Index condition : wanted(provider)) {
      for (const Index causer : listed(out, out.conditions[condition].causers))
        joined.join(provider.group, out.providers[causer].group);
    }
  }

  struct Rows {
    std::vector<Index> groups, edges;
  };
  std::vector<Rows> rows;
  std::vector<Index> number(out.groups.size(), nil);
  for (Index g = 0; g < out.groups.size(); ++g) {
    Index& component = number[joined.find(g)];
    if (component == nil) {
      component = static_cast<Index>(rows.size());
      rows.emplace_back();
    }
    out.groups[g].component = component;
    rows[component].groups.push_back(g);
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
