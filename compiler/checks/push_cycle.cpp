// Header: compiler/checks/check.hpp. Test: compiler/checks/push_cycle.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/clashes/exclusions.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/words/proposals.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace director::checks {

namespace {

std::string waiters_of(const Model& model, const Clash& clash) {
  const std::string second = name_of(model, clash.second_waiter);
  return clash.member == nullptr ? second + " waits"
                                 : fmt::format("{} and {} wait", name_of(model, clash.first_waiter), second);
}

std::string run_while(const Model& model, ProviderId causer, const ConditionUse& held) {
  const auto is_of_state = [&](const ConditionUse& use) {
    return model.conditions[use.id].state == model.conditions[held.id].state;
  };
  return fmt::format("{} run while {}{}", name_of(model, causer), name_of(model, held.id),
                     put_last(model, causer, is_of_state));
}

/// Where the two undo each other, everything that would still be one or the other clash.
std::string help_for_both(const Model& model, const Clash& clash) {
  std::vector<std::string> parts;
  if (runs_without(model, clash.first_causer, clash.second))
    parts.push_back(run_while(model, clash.first_causer, clash.second));
  if (runs_without(model, clash.second_causer, clash.first))
    parts.push_back(run_while(model, clash.second_causer, clash.first));
  const bool both_set =
      sets_against(model, clash.first_causer, clash.second) && sets_against(model, clash.second_causer, clash.first);
  if (parts.empty() || both_set) parts.emplace_back("one of them leave the other's state as it is");
  return fmt::format("let {}", fmt::join(parts, ", and "));
}

/// Where one of the two cannot run while the other condition holds.
std::string help_for_one(const Model& model, const Clash& clash) {
  const bool second_is_late = runs_without(model, clash.second_causer, clash.first).has_value();
  const GroupId group = model.providers[clash.first_causer].group;
  const bool one_group = group == model.providers[clash.second_causer].group;
  std::string out = "let " + (second_is_late ? run_while(model, clash.second_causer, clash.first)
                                             : run_while(model, clash.first_causer, clash.second));
  out += one_group ? fmt::format(", or add a provider to {} that causes both", name_of(model, group))
                   : std::string(", or let one provider cause both");
  if (one_group && second_is_late && clash.first_waiter == clash.second_waiter && !clash.first_may_precede)
    out += fmt::format(", or write {} before {}, as they are caused in this order", name_of(model, clash.second.id),
                       name_of(model, clash.first.id));
  return out;
}

} // namespace

void push_cycle(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const Clash& clash : input.conflicts.clashes()) {
    if (clash.kind != Clash::Kind::cycle) continue;
    dsl::Diagnostic& finding =
        findings.add(clash.second.span,
                     fmt::format("{} for {} and {}, and {}", waiters_of(model, clash), name_of(model, clash.first.id),
                                 name_of(model, clash.second.id),
                                 clash.because.size() > 1 ? "what causes the one undoes the other"
                                                          : "what causes the one cannot run while the other holds"));
    add_parties(model, clash, finding);
    finding.help = clash.because.size() > 1 ? help_for_both(model, clash) : help_for_one(model, clash);
  }
}

} // namespace director::checks
