// Header: compiler/checks/check.hpp. Test: compiler/checks/incompatible_pushes.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

namespace director::checks {

void incompatible_pushes(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const Clash& clash : input.conflicts.clashes()) {
    if (clash.kind != Clash::Kind::incompatible) continue;
    const std::string second = name_of(model, clash.second_causer);
    dsl::Diagnostic& finding = findings.add(
        clash.second.span, fmt::format("{} waits for {} and {}, which {} and {} cause: neither can run after the other",
                                       name_of(model, clash.second_waiter), name_of(model, clash.first.id),
                                       name_of(model, clash.second.id), name_of(model, clash.first_causer), second));
    add_parties(model, clash, finding);
    finding.help = fmt::format("let one provider of {} cause both, or let {} run whatever the other has caused",
                               name_of(model, model.providers[clash.second_causer].group), second);
  }
}

} // namespace director::checks
