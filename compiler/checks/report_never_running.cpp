// Header: compiler/checks/report_never_running.hpp. Test: compiler/checks/shadowed_provider.md.
// SPDX-License-Identifier: MIT
#include "compiler/checks/report_never_running.hpp"

#include "compiler/analysis/causing/exclusion.hpp"
#include "compiler/analysis/causing/promises.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/words/proposals.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace director::checks {

namespace {

/// Others that could bring about what it waits for, if all of them are requested and wait themselves; else none.
std::vector<ProviderId> find_waiting_setters(const Input& input, ProviderId id) {
  const Model& model = input.model;
  const auto sources = find_sources(model);
  std::vector<ProviderId> out;
  for (const ConditionUse& use : model.providers[id].when) {
    if (input.facts.may_hold(model, id, use)) continue;
    for (const Source& source : sources[model.conditions[use.id].state]) {
      if (!source.values.overlaps(model.conditions[use.id].accepts)) continue;
      if (!source.provider || input.facts.capable.contains(*source.provider) ||
          !input.facts.requested.contains(model.providers[*source.provider].group))
        return {};
      if (std::find(out.begin(), out.end(), *source.provider) == out.end()) out.push_back(*source.provider);
    }
  }
  return out;
}

void propose_beginning(const Input& input, ProviderId id, const std::vector<ProviderId>& setters,
                       dsl::Diagnostic& finding) {
  const std::string name = name_of(input.model, id), other = name_of(input.model, setters.front());
  if (setters == std::vector{id}) {
    finding.help = fmt::format("let {} begin without what it sets itself", name);
  } else if (setters.size() == 1 && find_waiting_setters(input, setters.front()) == std::vector{id}) {
    finding.notes.push_back({input.model.providers[setters.front()].span, fmt::format("nor can {}", other)});
    finding.help = fmt::format("let {} or {} begin without what the other one sets", name, other);
  } else {
    finding.help = fmt::format("let {}, or one of those that it waits for, begin without what another one sets", name);
  }
}

} // namespace

void report_never(const Input& input, ProviderId id, Findings& findings) {
  const std::string name = name_of(input.model, id);
  dsl::Diagnostic& finding = findings.add(input.model.providers[id].span, fmt::format("{} can never run", name));
  finding.rules_out = {input.model.providers[id].span};
  Idleness idleness = explain_idle(input, id);
  finding.notes = std::move(idleness.notes);
  const bool excluded = !explain_exclusion(input.model, input.facts, id).empty();
  const std::vector<ProviderId> setters = excluded ? std::vector<ProviderId>{} : find_waiting_setters(input, id);
  if (idleness.deadlock)
    finding.help = apart_help(input.model, *idleness.deadlock);
  else if (!setters.empty())
    propose_beginning(input, id, setters, finding);
  else
    propose_or_leave_out(input.model, input.facts, id,
                         excluded ? "say these conditions so that all of them can hold at once"
                                  : "request what brings that about",
                         finding);
}

void report_excluded(const Input& input, ProviderId id, Findings& findings) {
  const std::string name = name_of(input.model, id), group = name_of(input.model, input.model.providers[id].group);
  dsl::Diagnostic& finding = findings.add(
      input.model.providers[id].span, fmt::format("{} never runs: {} is requested only where it cannot", name, group));
  finding.rules_out = {input.model.providers[id].span};
  finding.notes = explain_exclusion(input.model, input.facts, id);
  propose_or_leave_out(input.model, input.facts, id, fmt::format("request {} elsewhere too", group), finding);
}

void report_idle(const Input& input, ProviderId id, const Refused& refused, Findings& findings) {
  const Taker& taker = refused.refusals.front().taker;
  dsl::Diagnostic& finding = findings.add(input.model.providers[id].span,
                                          fmt::format("{} never runs: whenever it is requested {} is held by others",
                                                      name_of(input.model, id), name_of(input.model, taker.group)));
  finding.rules_out = {input.model.providers[id].span};
  add_taker(input, refused, taker, finding.notes);
  propose_or_leave_out(input.model, input.facts, id, "request it where that is free", finding);
}

} // namespace director::checks
