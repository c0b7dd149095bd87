// Header: compiler/checks/check.hpp. Test: compiler/checks/needs_cycle.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

namespace director::checks {

namespace {

void report(const Model& model, const std::vector<ChainStep>& cycle, Findings& findings) {
  std::vector<GroupId> groups;
  for (const ChainStep& step : cycle) groups.push_back(step.from);
  groups.push_back(cycle.back().to);
  if (groups.size() == 2) {
    dsl::Diagnostic& finding = findings.add(cycle[0].span, fmt::format("{} needs itself", name_of(model, groups[0])));
    finding.rules_out = {cycle[0].span};
    finding.help = "a provider holds its own group already: remove the need";
    return;
  }
  dsl::Diagnostic& finding = findings.add(
      cycle[0].span, fmt::format("{}: no plan gets out of this cycle", chain_in_words(model, groups, "needs")));
  for (const ChainStep& step : cycle) finding.rules_out.push_back(step.span);
  add_chain(model, std::vector<ChainStep>(cycle.begin() + 1, cycle.end()), finding.notes);
  finding.help = fmt::format("remove one of these needs, or give {} a provider that does without",
                             name_of(model, cycle.back().from));
}

} // namespace

void needs_cycle(const Input& input, Findings& findings) {
  for (const std::vector<ChainStep>& cycle :
       find_need_cycles(input.model, input.graph, input.facts, input.shared.budget()))
    report(input.model, cycle, findings);
}

} // namespace director::checks
