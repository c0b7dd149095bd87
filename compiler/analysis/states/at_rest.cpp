// Header: compiler/analysis/states/at_rest.hpp. Test: compiler/checks/causer_not_running.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/states/at_rest.hpp"

namespace director::analysis {

Possible values_at_rest(const Model& model, const State& state) {
  Possible out{ValueSet::single(*state.initial), state.may_be_unset()};
  if (state.expires && state.expires->to) out.values = out.values.united(ValueSet::single(*state.expires->to));
  const Group& group = model.groups[state.of->id];
  if (!group.stop) return out;
  for (const ConditionUse& entry : group.stop->sets) {
    const Condition& set = model.conditions[entry.id];
    if (&model.states[set.state] == &state) out.values = out.values.united(set.accepts);
  }
  return out;
}

} // namespace director::analysis
