// Header: compiler/checks/check.hpp. Test: compiler/checks/imprecise_causing.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

namespace director::checks {

void imprecise_causing(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const Imprecise& fault : input.shared.imprecise()) {
    const Condition& promise = model.conditions[fault.promise.id];
    const Condition& wanted = model.conditions[fault.condition.id];
    dsl::Diagnostic& finding = findings.add(
        fault.promise.span,
        fmt::format("{} may also be {}, which {} does not accept: nothing pushes {} for it", quoted(promise.text),
                    values_in_words(model.states[promise.state], promise.accepts.without(wanted.accepts)),
                    quoted(wanted.text), name_of(model, fault.causer)));
    finding.rules_out = {fault.promise.span, fault.condition.span};
    finding.notes.push_back({fault.condition.span, fmt::format("{} waits for this", name_of(model, fault.waiter))});
    finding.help = fmt::format("promise what is waited for: `{}`", wanted.text);
  }
}

} // namespace director::checks
