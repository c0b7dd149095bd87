// Header: compiler/checks/check.hpp. Test: compiler/checks/state_without_source.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace director::checks {

void state_without_source(const Input& input, Findings& findings) {
  const Model& model = input.model;
  std::map<StateId, std::vector<Span>> compared;
  for (const Impossible& fault : input.facts.impossible) {
    if (fault.why != Impossible::Why::without_source) continue;
    for (const ConditionUse& use : fault.uses) compared[fault.state].push_back(use.span);
  }
  for (auto& [state, places] : compared) {
    std::sort(places.begin(), places.end());
    dsl::Diagnostic& finding = findings.add(
        places[0], fmt::format("{} never has a value, so no condition on it ever holds", name_of(model, state)));
    finding.rules_out = places;
    finding.notes.push_back(
        {model.states[state].name.span, "it has no `initial` value, is not `external`, and nothing causes or sets it"});
    for (std::size_t i = 1; i < places.size(); ++i) finding.notes.push_back({places[i], "looked at here too"});
    finding.help = "give it an `initial` value, make it `external`, or let a provider cause it";
  }
}

} // namespace director::checks
