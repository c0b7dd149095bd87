// Header: compiler/checks/code_check.hpp. Test: compiler/checks/undeclared_state_write.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/code_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace director::checks {

namespace {

struct Declared {
  ValueSet values;
  std::vector<std::string> words; ///< `Pose == standing`
};

Declared declared_for(const Model& model, const BodyOf& body, StateId state) {
  Declared out;
  for (const ConditionUse& use : declared_by(model, body)) {
    if (model.conditions[use.id].state == state) out.values = out.values.united(model.conditions[use.id].accepts);
    out.words.push_back(name_of(model, use.id));
  }
  return out;
}

/// All values that it may have, as far as they are known, if none of them is declared.
std::vector<std::string> undeclared(const State& state, const CodeWord& word, const Declared& declared) {
  std::vector<std::string> out;
  for (const std::vector<std::string>& names : *word.values) {
    const std::optional<std::int64_t> value = value_of(state, names);
    if (value && declared.values.contains(*value)) return {};
    out.push_back(quoted(names.front()));
  }
  return out;
}

std::string where_to_declare(const BodyOf& body) {
  switch (body.kind) {
  case BodyOf::Kind::start: return "declare it under `sets` of the handler: `start: {sets: ...}`";
  case BodyOf::Kind::stop: return "declare it under `sets` of the handler: `stop: {sets: ...}`";
  case BodyOf::Kind::provider: break;
  }
  return "declare it under `sets`";
}

} // namespace

void undeclared_state_write(const CodeInput& input, Findings& findings) {
  const Model& model = input.model;
  std::set<const CodeWord*> reported; // of a function that several bodies call
  for (const Body& body : input.bodies) {
    for (const CodeWord* word : body.words) {
      if (word->kind != CodeWord::Kind::set || !word->values) continue;
      const auto state = input.names.states.find(word->state);
      if (state == input.names.states.end()) continue;
      const Declared declared = declared_for(model, body.of, state->second);
      const std::vector<std::string> values = undeclared(model.states[state->second], *word, declared);
      if (values.empty() || !reported.insert(word).second) continue;
      dsl::Diagnostic& finding =
          findings.add(word->span, fmt::format("{} sets {} to {}, which it does not declare", name_of(model, body.of),
                                               name_of(model, state->second), list_of(values, "or")));
      finding.notes.push_back({span_of(model, body.of), fmt::format("{} is declared here", name_of(model, body.of))});
      finding.help = declared.words.empty() ? where_to_declare(body.of)
                                            : fmt::format("what it declares is {}", list_of(declared.words));
    }
  }
}

} // namespace director::checks
