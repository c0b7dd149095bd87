// Header: compiler/analysis/causing/undoing.hpp. Test: compiler/checks/undone_by_itself.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/undoing.hpp"

#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

namespace director::analysis {

ValueSet undoing_values(const Model& model, ProviderId provider, ConditionId condition, const ValueSet& values) {
  const StateId state = model.conditions[condition].state;
  ValueSet out = values.without(model.conditions[condition].accepts);
  const auto accept = [&](const Region& region) {
    const auto at = region.states.find(state);
    out = at == region.states.end() ? ValueSet{} : out.without(at->second);
  };
  const Provider& row = model.providers[provider];
  if (!row.stay.empty()) accept(region_of(model, row.stay));
  Region here = region_of(model, row.when);
  here.states.erase(state);
  for (const ProviderId other : model.groups[row.group].providers) {
    const Region region = region_of(model, model.providers[other].when);
    if (other != provider && compatible(here, region)) accept(region);
  }
  return out;
}

std::string stay_help(const Model& model, const Want& want, const ValueSet& values) {
  const StateId state = model.conditions[want.condition.id].state;
  return fmt::format("give {} a `stay` under which {} may be {}", name_of(model, want.waiter), name_of(model, state),
                     values_in_words(model.states[state], values));
}

} // namespace director::analysis
