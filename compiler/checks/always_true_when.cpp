// Header: compiler/checks/check.hpp. Test: compiler/checks/always_true_when.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

namespace director::checks {

void always_true_when(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const Provider& provider : model.providers) {
    for (const ConditionUse& use : provider.when) {
      const Condition& condition = model.conditions[use.id];
      const State& state = model.states[condition.state];
      if (state.may_be_unset() || condition.accepts != state.domain()) continue;
      dsl::Diagnostic& finding = findings.add(use.span, fmt::format("{} always holds: every value of {} satisfies it",
                                                                    quoted(condition.text), quoted(state.name.value)));
      finding.notes.push_back(
          {state.name.span, fmt::format("its values are {}", values_in_words(state, state.domain()))});
      finding.help = "leave it out";
    }
  }
}

} // namespace director::checks
