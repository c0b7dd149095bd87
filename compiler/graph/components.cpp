// Header: compiler/graph/components.hpp. Test: tests/compiler/graph/components_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/graph/components.hpp"

#include "compiler/base/disjoint_sets.hpp"
#include "compiler/model/causers.hpp"

#include <optional>

namespace director::compiler {

IdTable<GroupId, std::uint32_t> find_components(const Model& model) {
  DisjointSets sets(model.groups.size());
  for (const Edge& edge : model.edges) {
    if (edge.requester) sets.join(edge.requester->value, edge.target.value);
  }
  const Causers causers = find_causers(model);
  for (const Provider& waiter : model.providers) {
    for (const auto* conditions : {&waiter.when, &waiter.stay}) {
      for (const ConditionUse& condition : *conditions) {
        for (const ProviderId causer : causers[condition.id])
          sets.join(waiter.group.value, model.providers[causer].group.value);
      }
    }
  }
  std::uint32_t count = 0;
  IdTable<GroupId, std::optional<std::uint32_t>> numbers(model.groups.size());
  IdTable<GroupId, std::uint32_t> out(model.groups.size());
  for (const GroupId group : model.groups.ids()) {
    std::optional<std::uint32_t>& number = numbers[GroupId{sets.find(group.value)}];
    if (!number) number = count++;
    out[group] = *number;
  }
  return out;
}

} // namespace director::compiler
