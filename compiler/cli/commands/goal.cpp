// Header: compiler/cli/commands/goal.hpp. Test: tests/compiler/cli/commands/reachable_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/commands/goal.hpp"

#include "compiler/play/scenario/names.hpp"
#include "dsl/lexical/characters.hpp"
#include "dsl/reading/read_condition.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler::cli {

namespace {

using dsl::Diagnostic;

class GoalReader {
public:
  GoalReader(const Model& model, std::string_view words) : model_(model), words_(words), names_(model, findings) {}

  std::optional<analysis::Goal> goal() {
    if (words_.find_first_of("=<>!|&") != std::string::npos) return value();
    if (const auto state = model_.find_state(words_); state && !model_.find_group(words_)) {
      names_.error("bad_condition", {}, fmt::format("`{}` is a state", words_),
                   "name one of its values: " + example(*state));
      return std::nullopt;
    }
    const std::size_t dot = std::min(words_.find('.'), words_.size());
    const auto group = names_.group({words_.substr(0, dot), {}});
    if (!group) return std::nullopt;
    if (dot == words_.size()) return *group;
    const auto provider = names_.provider(*group, {words_.substr(dot + 1), {}});
    return provider ? std::optional<analysis::Goal>(*provider) : std::nullopt;
  }

  std::vector<Diagnostic> findings;

private:
  /// `Pose == standing`, read as the language reads a condition.
  std::optional<analysis::Goal> value() {
    dsl::YamlNode node;
    node.kind = dsl::YamlNode::Kind::scalar;
    node.text = words_;
    dsl::Reader reader(words_, findings);
    const auto condition = dsl::read_condition(reader, node, "--explain-reachable", dsl::ConditionUse::comparison);
    if (!condition) return std::nullopt;
    const auto state = names_.state(condition->state);
    if (!state) return std::nullopt;
    if (condition->op.value != dsl::Op::equal || condition->values.size() != 1) {
      names_.error("bad_condition", {}, fmt::format("expected one value of a state, found `{}`", words_),
                   "for example " + example(*state));
      return std::nullopt;
    }
    const auto number = names_.value(*state, condition->values.front());
    return number ? std::optional<analysis::Goal>(analysis::StateValue{*state, *number}) : std::nullopt;
  }

  std::string example(StateId id) const {
    const State& state = model_.states[id];
    return fmt::format("`{} == {}`", state.name.value, state.value_text(state.high));
  }

  const Model& model_;
  std::string words_;
  Names names_;
};

} // namespace

ParsedGoal parse_goal(const Model& model, const std::string& words) {
  GoalReader reader(model, std::string(dsl::trimmed(words)));
  ParsedGoal out{reader.goal(), {}};
  if (out.goal) return out;
  const Diagnostic& wrong = reader.findings.front();
  out.wrong = wrong.message + (wrong.help.empty() ? "" : "; " + wrong.help);
  return out;
}

} // namespace director::compiler::cli
