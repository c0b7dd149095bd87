// Header: compiler/lower/steps.hpp. Test: tests/compiler/lower/lower_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/lower/steps.hpp"

#include <algorithm>

namespace director::compiler {

namespace {

Range add_conditions(const std::vector<ConditionUse>& uses, Lowered& out) {
  std::vector<Index> rows;
  for (const ConditionUse& use : uses) rows.push_back(*condition_row(out, use.id));
  return add_list(out, rows);
}

/// The edges from the provider's group to its needs, in the order in which a plan picks them.
Range add_needs(const Model& model, const Provider& provider, Lowered& out) {
  std::vector<Index> rows;
  for (const Use<GroupId>& need : provider.needs) {
    for (const EdgeId edge : model.groups[provider.group].edges) {
      if (model.edges[edge].target == need.id) rows.push_back(row(edge));
    }
  }
  return add_list(out, rows);
}

Range add_causing(const Model& model, const Provider& provider, Lowered& out) {
  std::vector<Index> states;
  for (const ConditionUse& promise : provider.causing) {
    const Index state = row(model.conditions[promise.id].state);
    if (std::find(states.begin(), states.end(), state) == states.end()) states.push_back(state);
  }
  return add_list(out, states);
}

/// The inverse table: provider -> conditions that it causes.
IdTable<ProviderId, std::vector<Index>> effects_of(const Model& model, const Lowered& out) {
  IdTable<ProviderId, std::vector<Index>> effects(model.providers.size());
  for (Index condition = 0; condition < out.conditions.size(); ++condition) {
    for (const Index provider : out.view().list(out.conditions[condition].causers)) {
      effects[ProviderId{provider}].push_back(condition);
    }
  }
  return effects;
}

} // namespace

void lower_providers(const Model& model, Lowered& out) {
  const IdTable<ProviderId, std::vector<Index>> effects = effects_of(model, out);
  for (const ProviderId id : model.providers.ids()) {
    const Provider& provider = model.providers[id];
    director::Provider lowered;
    lowered.group = row(provider.group);
    lowered.when = add_conditions(provider.when, out);
    lowered.stay = add_conditions(provider.stay, out);
    lowered.needs = add_needs(model, provider, out);
    std::vector<Index> triggers;
    for (const Use<TriggerId>& trigger : provider.triggers) triggers.push_back(row(trigger.id));
    lowered.triggers = add_list(out, triggers);
    lowered.effects = add_list(out, effects[id]);
    lowered.causing = add_causing(model, provider, out);
    lowered.every = provider.every.value_or(0);
    out.providers.push_back(lowered);
  }
}

} // namespace director::compiler
