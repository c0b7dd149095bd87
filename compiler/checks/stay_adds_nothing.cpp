// Header: compiler/checks/check.hpp. Test: compiler/checks/stay_adds_nothing.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::checks {

namespace {

/// Whether the second holds wherever the first does.
bool implies(const Model& model, const Region& first, const Region& second) {
  return std::all_of(second.states.begin(), second.states.end(), [&](const auto& entry) {
    const State& state = model.states[entry.first];
    if (!state.may_be_unset() && state.domain().subset_of(entry.second)) return true; // it always holds
    const auto at = first.states.find(entry.first);
    return at != first.states.end() && at->second.subset_of(entry.second);
  });
}

} // namespace

void stay_adds_nothing(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const ProviderId id : model.providers.ids()) {
    const Provider& provider = model.providers[id];
    if (provider.stay.empty()) continue;
    const Region stay = region_of(model, provider.stay);
    if (stay.empty() || !implies(model, stay, region_of(model, provider.when))) continue;
    dsl::Diagnostic& finding =
        findings.add(provider.stay[0].span,
                     fmt::format("whenever the `stay` of {} holds its `when` does too, so it keeps nothing longer",
                                 name_of(model, id)));
    for (const ConditionUse& use : provider.when) finding.notes.push_back({use.span, "part of its `when`"});
    finding.help =
        "a `stay` requires less than the `when`: leave out what may be lost meanwhile, or leave it out altogether";
  }
}

} // namespace director::checks
