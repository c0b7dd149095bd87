// Header: compiler/checks/check.hpp. Test: compiler/checks/contradictory_when.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace director::checks {

namespace {

/// The condition after which no value is left, and the earlier ones that conflict with it.
struct Contradiction {
  ConditionUse last{};
  std::vector<ConditionUse> others;
};

Contradiction find_contradiction(const Model& model, const Impossible& fault) {
  const auto accepted = [&](const ConditionUse& use) { return model.conditions[use.id].accepts; };
  ValueSet left = model.states[fault.state].domain();
  Contradiction clash;
  for (const ConditionUse& use : fault.uses) {
    clash.last = use;
    left = left.intersected(accepted(use));
    if (left.empty()) break;
    clash.others.push_back(use);
  }
  // One that conflicts with the last alone is enough.
  for (const ConditionUse& use : clash.others) {
    if (!accepted(use).overlaps(accepted(clash.last))) {
      clash.others = {use};
      break;
    }
  }
  if (accepted(clash.last).empty()) clash.others.clear();
  return clash;
}

/// Whether this unordered value is where the comparison would include it.
bool seems_to_accept(const Condition& condition, std::int64_t value) {
  using Op = Condition::Op;
  if (condition.op == Op::less || condition.op == Op::less_equal) return value < condition.operands[0];
  return (condition.op == Op::greater || condition.op == Op::greater_equal) && value > condition.operands[0];
}

dsl::Diagnostic& report_empty(const Model& model, const ConditionUse& use, Findings& findings) {
  const StateId id = model.conditions[use.id].state;
  const State& state = model.states[id];
  dsl::Diagnostic& finding =
      findings.add(use.span, fmt::format("no value of {} satisfies {}", name_of(model, id), name_of(model, use.id)));
  finding.notes.push_back({state.name.span, fmt::format("its values are {}", values_in_words(state, state.domain()))});
  for (const std::int64_t value : state.unordered) {
    if (seems_to_accept(model.conditions[use.id], value))
      finding.notes.push_back(
          {state.value_spans[static_cast<std::size_t>(value)],
           fmt::format("`{}` is `unordered`: it satisfies no ordered comparison", state.value_text(value))});
  }
  finding.help = "correct the value, or leave the condition out";
  return finding;
}

/// Of what a provider or a handler causes or sets, what cannot be.
void report_all_empty(const Model& model, const std::vector<ConditionUse>& uses, Findings& findings) {
  for (const ConditionUse& use : uses) {
    if (model.conditions[use.id].accepts.empty()) report_empty(model, use, findings);
  }
}

} // namespace

void contradictory_when(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const Impossible& fault : input.facts.impossible) {
    if (fault.why != Impossible::Why::contradictory) continue;
    const Contradiction clash = find_contradiction(model, fault);
    const std::string last = name_of(model, clash.last.id);
    const std::string word = fault.stay ? "stay" : "when";
    if (clash.others.empty()) {
      dsl::Diagnostic& finding = report_empty(model, clash.last, findings);
      if (!fault.stay) finding.rules_out = {clash.last.span};
      continue;
    }
    std::vector<std::string> others;
    for (const ConditionUse& use : clash.others) others.push_back(name_of(model, use.id));
    dsl::Diagnostic& finding =
        findings.add(clash.last.span, fmt::format("{} and {} never hold together, so the `{}` of {} never does",
                                                  list_of(others, "and"), last, word, name_of(model, fault.provider)));
    if (!fault.stay) {
      finding.rules_out = {clash.last.span};
      for (const ConditionUse& use : clash.others) finding.rules_out.push_back(use.span);
    }
    for (const ConditionUse& use : clash.others)
      finding.notes.push_back({use.span, fmt::format("{} is here", name_of(model, use.id))});
    finding.help = clash.others.size() == 1 && model.conditions[clash.last.id].op == Condition::Op::equal &&
                           model.conditions[clash.others[0].id].op == Condition::Op::equal
                       ? fmt::format("for one or the other, write alternatives: `{}|{}`",
                                     model.conditions[clash.others[0].id].text,
                                     model.states[fault.state].value_text(model.conditions[clash.last.id].operands[0]))
                       : "leave one of them out, or make two providers of it";
  }
  for (const Provider& provider : model.providers) {
    report_all_empty(model, provider.causing, findings);
    report_all_empty(model, provider.sets, findings);
  }
  for (const Group& group : model.groups) {
    for (const auto* handler : {&group.start, &group.stop}) {
      if (*handler) report_all_empty(model, (*handler)->sets, findings);
    }
  }
}

} // namespace director::checks
