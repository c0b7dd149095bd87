// Header: compiler/checks/check.hpp. Test: compiler/checks/unreachable_when.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

namespace director::checks {

namespace {

std::string describe(const Model& model, const Source& source) {
  const State& state = model.states[source.state];
  const std::string values = values_in_words(state, source.values);
  switch (source.kind) {
  case Source::Kind::initial: return fmt::format("{} is {} at the start", quoted(state.name.value), values);
  case Source::Kind::external: return fmt::format("{} is set from outside", quoted(state.name.value));
  case Source::Kind::expires: return fmt::format("it expires to {}", values);
  case Source::Kind::causing: return fmt::format("{} causes {}", name_of(model, *source.provider), values);
  case Source::Kind::sets: return fmt::format("{} sets {}", name_of(model, *source.provider), values);
  case Source::Kind::start: return fmt::format("the start of {} sets {}", name_of(model, *source.group), values);
  case Source::Kind::stop: return fmt::format("the stop of {} sets {}", name_of(model, *source.group), values);
  }
  return {};
}

std::string all_of(const Model& model, const std::vector<ConditionUse>& uses) {
  std::vector<std::string> names;
  for (const ConditionUse& use : uses) names.push_back(name_of(model, use.id));
  return list_of(names);
}

} // namespace

void unreachable_when(const Input& input, Findings& findings) {
  const Model& model = input.model;
  const auto sources = find_sources(model);
  for (const Impossible& fault : input.facts.impossible) {
    if (fault.why != Impossible::Why::unreachable) continue;
    const State& state = model.states[fault.state];
    dsl::Diagnostic& finding =
        findings.add(fault.uses.back().span,
                     fmt::format("{} never {}: {} is only ever {}", all_of(model, fault.uses),
                                 fault.uses.size() == 1 ? "holds" : "hold together", quoted(state.name.value),
                                 values_in_words(state, input.facts.declared[fault.state])));
    for (const ConditionUse& use : fault.uses) finding.rules_out.push_back(use.span);
    for (std::size_t i = 0; i + 1 < fault.uses.size(); ++i)
      finding.notes.push_back({fault.uses[i].span, fmt::format("{} is here", name_of(model, fault.uses[i].id))});
    for (const Source& source : sources[fault.state]) finding.notes.push_back({source.span, describe(model, source)});
    finding.help =
        fmt::format("let a provider cause what is waited for, or make {} `external`", quoted(state.name.value));
  }
}

} // namespace director::checks
