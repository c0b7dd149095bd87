// Door: compiler/play/row_names.hpp. Test: tests/compiler/cli/trace_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/row_names.hpp"

#include "compiler/lower/level_names.hpp"

namespace director::compiler {

RowNames::RowNames(const Model& model, const Lowered& lowered)
    : tables_(lowered.view()),
      behaviour_(model.name),
      levels_(level_names(model, lowered)) {
  for (const Group& group : model.groups) groups_.push_back(group.name.value);
  for (const Provider& provider : model.providers) providers_.push_back(provider.name);
  for (const EdgeId id : model.edges.ids()) edges_.push_back(model.edge_name(id));
  for (const ConditionId id : lowered.condition_ids) conditions_.push_back(model.conditions[id].text);
  for (const State& state : model.states) {
    states_.push_back(state.name.value);
    values_.push_back(state.is_range ? std::vector<std::string>{} : state.values);
  }
  for (const Trigger& trigger : model.triggers) triggers_.push_back(trigger.name);
}

const char* RowNames::value(const void* self, Index state, std::int32_t number) {
  if (number == unset) return "unset";
  const auto& values = static_cast<const RowNames*>(self)->values_[state];
  const auto place = static_cast<std::size_t>(number);
  return place < values.size() ? values[place].c_str() : "";
}

director::Names RowNames::names() const {
  const auto find = []<std::vector<std::string> RowNames::* all>() {
    return [](const void* self, Index row) {
      const std::vector<std::string>& rows = static_cast<const RowNames*>(self)->*all;
      return row < rows.size() ? rows[row].c_str() : "";
    };
  };
  return {.self = this,
          .group = find.operator()<&RowNames::groups_>(),
          .provider = find.operator()<&RowNames::providers_>(),
          .edge = find.operator()<&RowNames::edges_>(),
          .condition = find.operator()<&RowNames::conditions_>(),
          .state = find.operator()<&RowNames::states_>(),
          .value = &value,
          .trigger = find.operator()<&RowNames::triggers_>(),
          .level = find.operator()<&RowNames::levels_>(),
          .tables = &tables_,
          .behaviour = behaviour_.c_str()};
}

} // namespace director::compiler
