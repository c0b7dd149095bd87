// Header: compiler/checks/check.hpp. Test: compiler/checks/unset_is_false.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

namespace director::checks {

namespace {

void look_at(const Input& input, const std::vector<ConditionUse>& uses, Findings& findings) {
  const Model& model = input.model;
  for (const ConditionUse& use : uses) {
    const Condition& condition = model.conditions[use.id];
    const State& state = model.states[condition.state];
    if (condition.op != Condition::Op::not_equal || !state.may_be_unset()) continue;
    if (input.facts.declared[condition.state].empty()) continue; // never set at all: state_without_source
    if (condition.accepts.empty()) continue;                     // false anyway: contradictory_when
    dsl::Diagnostic& finding = findings.add(
        use.span, fmt::format("{} is false while {} is unset", quoted(condition.text), quoted(state.name.value)));
    if (state.initial) {
      finding.notes.push_back({state.expires->span, "it becomes unset here"});
      finding.help = "name the value that it expires to: `expires: {after: ..., to: ...}`";
      continue;
    }
    finding.notes.push_back({state.name.span, "it has no `initial` value"});
    if (state.expires && !state.expires->to) {
      finding.notes.push_back({state.expires->span, "and it becomes unset here"});
      finding.help = "give the state an `initial` value and a value that it expires to, or say which values you mean "
                     "with `==`";
    } else {
      finding.help = "give the state an `initial` value, or say which values you mean with `==`";
    }
  }
}

} // namespace

void unset_is_false(const Input& input, Findings& findings) {
  for (const Provider& provider : input.model.providers) {
    look_at(input, provider.when, findings);
    look_at(input, provider.stay, findings);
  }
}

} // namespace director::checks
