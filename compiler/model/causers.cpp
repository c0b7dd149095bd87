// Header: compiler/model/causers.hpp. Test: tests/compiler/lower/lower_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/model/causers.hpp"

namespace director::compiler {

Causers find_causers(const Model& model) {
  IdTable<StateId, std::vector<ProviderId>> by_state(model.states.size());
  for (const ProviderId id : model.providers.ids()) {
    for (const ConditionUse& promise : model.providers[id].causing) {
      std::vector<ProviderId>& row = by_state[model.conditions[promise.id].state];
      if (row.empty() || row.back() != id) row.push_back(id);
    }
  }
  Causers out(model.conditions.size());
  for (const ConditionId condition : model.conditions.ids()) {
    for (const ProviderId causer : by_state[model.conditions[condition].state]) {
      if (model.causes(causer, condition)) out[condition].push_back(causer);
    }
  }
  return out;
}

} // namespace director::compiler
