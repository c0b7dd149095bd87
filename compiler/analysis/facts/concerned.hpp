#pragma once
// SPDX-License-Identifier: MIT
// Finds the groups that a new fact may concern, by the declarations.

#include "compiler/analysis/states/sources.hpp"
#include "compiler/graph/graph.hpp"
#include "compiler/model/model.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace director::analysis {

using namespace director::compiler;

struct Concerned {
  using Sets = std::vector<std::pair<StateId, const Source*>>;

  IdTable<GroupId, std::vector<GroupId>> needers; ///< groups with a provider that needs it
  IdTable<StateId, std::vector<GroupId>> waiters; ///< groups with a condition on it
  IdTable<ProviderId, Sets> set_by_provider;
  IdTable<GroupId, Sets> set_by_handlers;
  IdTable<GroupId, std::size_t> place; ///< in the graph's order
};

/// `sources` must outlive this.
Concerned find_concerned(const Model& model, const Graph& graph, const IdTable<StateId, std::vector<Source>>& sources);

/// From each group with a condition up to all that may need it.
IdSet<GroupId> find_waiting(const Model& model, const Concerned& concerned);

} // namespace director::analysis
