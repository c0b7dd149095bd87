// Door: compiler/checks/check.hpp. Test: compiler/checks/imprecise_causing.md.
#include "compiler/checks/analysis/facts.hpp"
#include "compiler/checks/analysis/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::checks {

namespace {

/// Providers with a promise about each state, in order.
IdTable<StateId, std::vector<ProviderId>> find_promisers(const Model& model) {
  IdTable<StateId, std::vector<ProviderId>> out(model.states.size());
  for (const ProviderId id : model.providers.ids()) {
    for (const ConditionUse& promise : model.providers[id].causing) {
      std::vector<ProviderId>& row = out[model.conditions[promise.id].state];
      if (row.empty() || row.back() != id) row.push_back(id);
    }
  }
  return out;
}

} // namespace

void imprecise_causing(const Input& input, Findings& findings) {
  const Model& model = input.model;
  const auto promisers = find_promisers(model);
  for (const ProviderId waiter : model.providers.ids()) {
    if (!input.facts.requested.contains(model.providers[waiter].group)) continue;
    for (const ConditionUse& condition : model.providers[waiter].when) {
      const Condition& wanted = model.conditions[condition.id];
      const std::vector<ProviderId>& causers = promisers[wanted.state];
      if (std::any_of(causers.begin(), causers.end(), [&](ProviderId id) { return model.causes(id, condition.id); }))
        continue;
      for (const ProviderId causer : causers) {
        if (model.providers[causer].group == model.providers[waiter].group) continue;
        for (const ConditionUse& use : model.providers[causer].causing) {
          const Condition& promise = model.conditions[use.id];
          if (promise.state != wanted.state || promise.accepts.intersected(wanted.accepts).empty()) continue;
          dsl::Diagnostic& finding = findings.add(
              use.span,
              fmt::format("{} may also be {}, which {} does not accept: nothing pushes {} for it", quoted(promise.text),
                          values_in_words(model.states[promise.state], promise.accepts.without(wanted.accepts)),
                          quoted(wanted.text), name_of(model, causer)));
          finding.notes.push_back({condition.span, fmt::format("{} waits for this", name_of(model, waiter))});
          finding.help = fmt::format("promise what is waited for: `{}`", wanted.text);
        }
      }
    }
  }
}

} // namespace director::checks
