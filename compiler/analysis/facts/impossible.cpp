// Header: compiler/analysis/facts/impossible.hpp. Test: tests/compiler/analysis/facts/facts_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/impossible.hpp"

#include "compiler/analysis/states/region.hpp"

#include <utility>

namespace director::analysis {

namespace {

void add_impossible(const Model& model, const IdTable<StateId, std::vector<Source>>& sources,
                    const IdTable<StateId, ValueSet>& declared, ProviderId id, bool stay,
                    std::vector<Impossible>& out) {
  const Provider& provider = model.providers[id];
  const std::vector<ConditionUse>& conditions = stay ? provider.stay : provider.when;
  for (const auto& [state, accepted] : region_of(model, conditions).states) {
    Impossible fault{id, stay, state, Impossible::Why::contradictory, {}};
    if (!accepted.empty()) {
      if (accepted.overlaps(declared[state])) continue;
      fault.why = sources[state].empty() ? Impossible::Why::without_source : Impossible::Why::unreachable;
    }
    for (const ConditionUse& use : conditions) {
      if (model.conditions[use.id].state == state) fault.uses.push_back(use);
    }
    out.push_back(std::move(fault));
  }
}

} // namespace

IdTable<StateId, ValueSet> find_declared(const Model& model, const IdTable<StateId, std::vector<Source>>& sources) {
  IdTable<StateId, ValueSet> out(model.states.size());
  for (const StateId state : model.states.ids()) {
    for (const Source& source : sources[state]) out[state] = out[state].united(source.values);
  }
  return out;
}

std::vector<Impossible> find_impossible(const Model& model, const IdTable<StateId, std::vector<Source>>& sources,
                                        const IdTable<StateId, ValueSet>& declared) {
  std::vector<Impossible> out;
  for (const ProviderId id : model.providers.ids()) {
    add_impossible(model, sources, declared, id, false, out);
    add_impossible(model, sources, declared, id, true, out);
  }
  return out;
}

} // namespace director::analysis
