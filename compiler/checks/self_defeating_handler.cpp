// Header: compiler/checks/check.hpp. Test: compiler/checks/self_defeating_handler.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/self_defeats.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

namespace director::checks {

void self_defeating_handler(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const SelfDefeat& fault : find_self_defeats(model, input.facts)) {
    const std::string group = name_of(model, fault.group), provider = name_of(model, fault.provider);
    const std::string condition = name_of(model, fault.condition.id);
    dsl::Diagnostic& finding =
        findings.add(fault.entry.span, fmt::format("the {} of {} sets {}, and then {} {}",
                                                   fault.stop ? "stop" : "start", group, name_of(model, fault.entry.id),
                                                   provider, fault.stop ? "can run again" : "cannot run any more"));
    finding.rules_out = {fault.condition.span};
    finding.notes.push_back(
        {fault.condition.span, fault.stop ? fmt::format("{} is stopped when {} does not hold", group, condition)
                                          : fmt::format("{} runs only while {}", provider, condition)});
    finding.help = fault.stop ? "let the stop leave that state as it is, or wait for another one"
                              : fmt::format("let a `stay` of {} accept that value, or let its body set it when it is "
                                            "done",
                                            provider);
  }
}

} // namespace director::checks
