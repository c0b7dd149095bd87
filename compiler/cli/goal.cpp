// Door: compiler/cli/goal.hpp. Test: tests/cli/reachable_test.cpp.
#include "compiler/cli/goal.hpp"

#include "compiler/play/names.hpp"

#include <fmt/format.h>

namespace director::compiler::cli {

namespace {

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(' ') + 1 - first));
}

std::optional<checks::Goal> look_up(Names& names, const std::string& words) {
  if (const std::size_t equal = words.find("=="); equal != std::string::npos) {
    const auto state = names.state({trimmed(words.substr(0, equal)), {}});
    if (!state) return std::nullopt;
    const auto value = names.value(*state, {trimmed(words.substr(equal + 2)), {}});
    return value ? std::optional<checks::Goal>(checks::StateValue{*state, *value}) : std::nullopt;
  }
  const std::size_t dot = std::min(words.find('.'), words.size());
  const auto group = names.group({trimmed(words.substr(0, dot)), {}});
  if (!group) return std::nullopt;
  if (dot == words.size()) return *group;
  const auto provider = names.provider(*group, {trimmed(words.substr(dot + 1)), {}});
  return provider ? std::optional<checks::Goal>(*provider) : std::nullopt;
}

} // namespace

ParsedGoal parse_goal(const Model& model, const std::string& words) {
  std::vector<dsl::Diagnostic> findings;
  Names names(model, findings);
  ParsedGoal out{look_up(names, words), {}};
  if (!out.goal)
    out.wrong = findings.front().message + (findings.front().help.empty() ? "" : "; " + findings.front().help);
  return out;
}

} // namespace director::compiler::cli
