// Header: compiler/checks/check.hpp. Test: compiler/checks/push_cycle.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

namespace director::checks {

void push_cycle(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const Clash& clash : input.conflicts.clashes()) {
    if (clash.kind != Clash::Kind::cycle) continue;
    dsl::Diagnostic& finding =
        findings.add(clash.second.span,
                     fmt::format("{} waits for {} and {}, and {}", name_of(model, clash.second_waiter),
                                 name_of(model, clash.first.id), name_of(model, clash.second.id),
                                 clash.because.size() > 1 ? "what causes the one undoes the other"
                                                          : "what causes the one cannot run while the other holds"));
    add_parties(model, clash, finding);
    finding.help = clash.because.size() > 1 ? "let one of them leave the other's state as it is"
                                            : "let one provider cause both, or request the two one after the other";
  }
}

} // namespace director::checks
