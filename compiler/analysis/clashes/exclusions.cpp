// Header: compiler/analysis/clashes/exclusions.hpp. Test: compiler/checks/push_cycle.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/clashes/exclusions.hpp"

#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

namespace director::analysis {

using dsl::Note;

std::optional<Note> excludes(const Model& model, ProviderId provider, ProviderId other) {
  const std::vector<ConditionUse>& when = model.providers[provider].when;
  const Region region = region_of(model, when), caused = region_of(model, model.providers[other].causing);
  for (const ConditionUse& use : when) {
    const StateId state = model.conditions[use.id].state;
    const auto at = caused.states.find(state);
    if (at == caused.states.end() || at->second.overlaps(region.states.at(state))) continue;
    return runs_only_while(model, provider, use);
  }
  return std::nullopt;
}

std::optional<Note> runs_without(const Model& model, ProviderId causer, const ConditionUse& other) {
  const Condition& wanted = model.conditions[other.id];
  const std::vector<ConditionUse>& when = model.providers[causer].when;
  const Region region = region_of(model, when);
  const auto at = region.states.find(wanted.state);
  if (at == region.states.end() || at->second.overlaps(wanted.accepts)) return std::nullopt;
  for (const ConditionUse& use : when) {
    if (model.conditions[use.id].state == wanted.state) return runs_only_while(model, causer, use);
  }
  return std::nullopt;
}

std::optional<Note> sets_against(const Model& model, ProviderId causer, const ConditionUse& other) {
  const Condition& wanted = model.conditions[other.id];
  const Provider& provider = model.providers[causer];
  const ValueSet set = values_set_by(model, provider, wanted.state);
  if (set.empty() || set.overlaps(wanted.accepts)) return std::nullopt;
  for (const bool promised : {true, false}) {
    for (const ConditionUse& use : promised ? provider.causing : provider.sets) {
      if (model.conditions[use.id].state != wanted.state) continue;
      return Note{use.span, fmt::format("{} {} {}", name_of(model, causer), promised ? "causes" : "sets",
                                        name_of(model, use.id))};
    }
  }
  return std::nullopt;
}

std::optional<Note> undoes(const Model& model, ProviderId causer, const ConditionUse& other) {
  std::optional<Note> note = runs_without(model, causer, other);
  return note ? note : sets_against(model, causer, other);
}

} // namespace director::analysis
