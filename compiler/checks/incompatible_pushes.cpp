// Header: compiler/checks/check.hpp. Test: compiler/checks/incompatible_pushes.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/clashes/exclusions.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/words/proposals.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <string>

namespace director::checks {

namespace {

std::string run_after(const Model& model, ProviderId causer, ProviderId other) {
  const Region caused = region_of(model, model.providers[other].causing);
  const auto is_of_caused = [&](const ConditionUse& use) {
    return caused.states.count(model.conditions[use.id].state) != 0;
  };
  return fmt::format("{} run whatever {} has caused{}", name_of(model, causer), name_of(model, other),
                     put_last(model, causer, is_of_caused));
}

/// The group is pushed to the first provider until its condition holds, and only then to the second one. So it is
/// enough if the second one can run then, unless the second condition may hold before.
std::string help_for_two(const Model& model, const Clash& clash) {
  const ProviderId first = clash.first_causer, second = clash.second_causer;
  std::string out = fmt::format("add a provider to {} that causes both", name_of(model, model.providers[second].group));
  if (!clash.second_may_precede && !sets_against(model, second, clash.first))
    out += ", or let " + run_after(model, second, first);
  return out;
}

} // namespace

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
    finding.help = help_for_two(model, clash);
  }
}

} // namespace director::checks
