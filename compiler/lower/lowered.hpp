#pragma once
// SPDX-License-Identifier: MIT
// The tables of runtime/core/base/tables.hpp as values that own their rows, and the mapping from rows to the Model.
// Rows of groups, providers, edges, states and triggers have the numbers of the Model's ids.

#include "compiler/model/ids.hpp"
#include "runtime/core/base/tables.hpp"

#include <vector>

namespace director::compiler {

struct Lowered {
  std::vector<director::Group> groups;
  std::vector<director::Provider> providers;
  std::vector<director::Edge> edges;
  std::vector<director::Level> levels; ///< edge after edge, in the order of Edge::levels in the Model
  std::vector<director::Condition> conditions;
  std::vector<director::Interval> intervals;
  std::vector<director::StateVariable> states;
  std::vector<director::Trigger> triggers;
  std::vector<director::Promise> promises;
  std::vector<Index> lists;
  std::vector<director::Component> components;
  std::vector<Index> plan_groups;
  std::vector<Index> listened;
  Index root_edges = 0;
  Index most_edges = 0;

  std::vector<ConditionId> condition_ids; ///< row of `conditions` -> its id in the Model; ascending
  /// Providers with so many plans that their aims include the conditions of all that they need, also of what no plan
  /// picks.
  std::vector<ProviderId> wide_aims;

  /// A view of the vectors above: valid as long as this object exists and is not assigned to.
  Tables view() const;
};

} // namespace director::compiler
