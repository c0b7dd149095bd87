// Header: compiler/lower/lower.hpp. Test: tests/compiler/lower/lower_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/lower/lower.hpp"

#include "compiler/lower/steps.hpp"

#include <algorithm>

namespace director::compiler {

Range add_list(Lowered& out, std::span<const Index> rows) {
  const auto begin = static_cast<Index>(out.lists.size());
  out.lists.insert(out.lists.end(), rows.begin(), rows.end());
  return {begin, static_cast<Index>(out.lists.size())};
}

std::optional<Index> condition_row(const Lowered& out, ConditionId id) {
  const auto at = std::lower_bound(out.condition_ids.begin(), out.condition_ids.end(), id);
  if (at == out.condition_ids.end() || *at != id) return std::nullopt;
  return static_cast<Index>(at - out.condition_ids.begin());
}

Tables Lowered::view() const {
  Tables tables;
  tables.groups = groups;
  tables.providers = providers;
  tables.edges = edges;
  tables.levels = levels;
  tables.conditions = conditions;
  tables.intervals = intervals;
  tables.states = states;
  tables.triggers = triggers;
  tables.promises = promises;
  tables.lists = lists;
  tables.components = components;
  tables.plan_groups = plan_groups;
  tables.listened = listened;
  tables.root_edges = root_edges;
  tables.most_edges = most_edges;
  return tables;
}

Lowered lower(const Model& model) {
  Lowered out;
  lower_states(model, out);
  lower_conditions(model, out);
  lower_edges(model, out);
  lower_providers(model, out);
  lower_promises(model, out);
  lower_groups(model, out);
  lower_aims(model, out);
  lower_components(model, out);
  lower_users(out);
  lower_traits(out);
  return out;
}

} // namespace director::compiler
