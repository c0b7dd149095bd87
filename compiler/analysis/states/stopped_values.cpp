// Header: compiler/analysis/states/stopped_values.hpp. Test: compiler/checks/causer_not_running.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/states/stopped_values.hpp"

namespace director::analysis {

Possible values_while_stopped(const Model& model, const State& state) {
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

const ConditionUse* find_own_step(const Model& model, ProviderId id) {
  const Provider& provider = model.providers[id];
  for (const ConditionUse& use : provider.when) {
    const Condition& condition = model.conditions[use.id];
    const State& state = model.states[condition.state];
    if (state.of && state.of->id == provider.group &&
        !values_while_stopped(model, state).values.overlaps(condition.accepts))
      return &use;
  }
  return nullptr;
}

} // namespace director::analysis
