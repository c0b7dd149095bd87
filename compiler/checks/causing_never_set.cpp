// Header: compiler/checks/code_check.hpp. Test: compiler/checks/causing_never_set.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/code_check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::checks {

namespace {

/// Whether some value that the body may set satisfies the promise.
bool may_keep(const CodeInput& input, const CodeWord& word, const Condition& promise) {
  if (word.kind != CodeWord::Kind::set) return false;
  const auto state = input.names.states.find(word.state);
  if (state == input.names.states.end()) return true; // unknown states are ignored
  if (state->second != promise.state) return false;
  if (!word.values) return true;
  return std::any_of(word.values->begin(), word.values->end(), [&](const std::vector<std::string>& names) {
    const std::optional<std::int64_t> value = value_of(input.model.states[promise.state], names);
    return !value || promise.accepts.contains(*value);
  });
}

} // namespace

void causing_never_set(const CodeInput& input, Findings& findings) {
  const Model& model = input.model;
  for (const Body& body : input.bodies) {
    if (!body.of.provider || !body.is_whole() || body.is_unwritten()) continue;
    for (const ConditionUse& promise : model.providers[*body.of.provider].causing) {
      const Condition& condition = model.conditions[promise.id];
      if (std::any_of(body.possible.begin(), body.possible.end(),
                      [&](const CodeWord* word) { return may_keep(input, *word, condition); }))
        continue;
      dsl::Diagnostic& finding =
          findings.add(promise.span, fmt::format("no path of {} sets what it promises, {}", name_of(model, body.of),
                                                 name_of(model, promise.id)));
      finding.notes.push_back({body.function->span, "its body"});
      const State& state = model.states[condition.state];
      finding.help = state.external
                         ? fmt::format("if the outside sets `{}` when it has come about, `allow` this with that reason",
                                       state.name.value)
                         : "let the body set it, or leave the promise out";
    }
  }
}

} // namespace director::checks
