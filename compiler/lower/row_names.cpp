// Header: compiler/lower/row_names.hpp. Test: tests/compiler/cli/commands/trace_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/lower/row_names.hpp"

#include "compiler/lower/level_names.hpp"

namespace director::compiler {

RowNames::RowNames(const Model& model, const Lowered& lowered) : tables_(lowered.view()) {
  texts_.behaviour = model.name;
  texts_.levels = level_names(model, lowered);
  for (const LevelUse& use : level_uses(model, lowered)) texts_.add(use);
  for (const Group& group : model.groups) texts_.groups.push_back(group.name.value);
  for (const Provider& provider : model.providers) texts_.providers.push_back(provider.name);
  for (const EdgeId id : model.edges.ids()) texts_.edges.push_back(model.edge_name(id));
  for (const ConditionId id : lowered.condition_ids) texts_.conditions.push_back(model.conditions[id].text);
  for (const State& state : model.states) {
    texts_.states.push_back(state.name.value);
    texts_.values.push_back(state.is_range ? std::vector<std::string>{} : state.values.words());
  }
  for (const Trigger& trigger : model.triggers) texts_.triggers.push_back(trigger.name);
}

} // namespace director::compiler
