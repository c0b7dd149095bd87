// Door: compiler/checks/check.hpp. Test: compiler/checks/imprecise_causing.md.
#include "compiler/checks/analysis/facts.hpp"
#include "compiler/checks/analysis/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::checks {

namespace {

bool is_served(const Graph& graph, ProviderId waiter, const ConditionUse& condition) {
  return std::any_of(graph.causing.begin(), graph.causing.end(), [&](const Graph::Causing& arrow) {
    return arrow.waiter == waiter && arrow.condition.id == condition.id;
  });
}

} // namespace

void imprecise_causing(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const ProviderId waiter : model.providers.ids()) {
    if (!input.facts.requested.contains(model.providers[waiter].group)) continue;
    for (const ConditionUse& condition : model.providers[waiter].when) {
      const Condition& wanted = model.conditions[condition.id];
      if (is_served(input.graph, waiter, condition)) continue;
      for (const ProviderId causer : model.providers.ids()) {
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
