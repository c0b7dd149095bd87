// Header: compiler/checks/check.hpp. Test: compiler/checks/foreign_set.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

namespace director::checks {

namespace {

void look_at(const Model& model, GroupId group, const std::vector<ConditionUse>& uses, Findings& findings) {
  for (const ConditionUse& use : uses) {
    const State& state = model.states[model.conditions[use.id].state];
    if (!state.of || state.of->id == group) continue;
    dsl::Diagnostic& finding =
        findings.add(use.span, fmt::format("{} cannot set {}: that belongs to {}", name_of(model, group),
                                           quoted(state.name.value), name_of(model, state.of->id)));
    finding.notes.push_back(
        {state.of->span, "it is set by this group alone, and returns to its initial value with it"});
    finding.help = fmt::format("let {} set it, or leave out `of`", name_of(model, state.of->id));
  }
}

} // namespace

void foreign_set(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const Provider& provider : model.providers) {
    look_at(model, provider.group, provider.causing, findings);
    look_at(model, provider.group, provider.sets, findings);
  }
  for (const GroupId id : model.groups.ids()) {
    const Group& group = model.groups[id];
    if (group.start) look_at(model, id, group.start->sets, findings);
    if (group.stop) look_at(model, id, group.stop->sets, findings);
  }
}

} // namespace director::checks
