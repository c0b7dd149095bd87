// Header: compiler/play/scenario/names.hpp. Test: tests/compiler/play/scenario/resolve_scenario_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/scenario/names.hpp"

#include "compiler/model/resolve/no_such_value.hpp"
#include "dsl/lexical/suggest.hpp"
#include "dsl/source/shortened.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace director::compiler {

using dsl::Diagnostic;

Diagnostic& Names::error(std::string_view id, Span span, std::string message, std::string help) {
  findings_.push_back({std::string(id), dsl::Level::error, span, std::move(message), {}, std::move(help)});
  return findings_.back();
}

Diagnostic& Names::undefined(Span span, std::string message, std::string_view name,
                             const std::vector<std::string>& known) {
  std::string help = known.empty()       ? "there is none"
                     : known.size() == 1 ? fmt::format("there is only `{}`", known.front())
                                         : "one of " + dsl::shortened_list(known);
  if (const auto nearest = dsl::suggest(name, known)) help = fmt::format("did you mean `{}`?", *nearest);
  return error("undefined_name", span, std::move(message), std::move(help));
}

template <class Things>
void Names::undefined(const Word& name, std::string_view kind, const Things& things) {
  std::vector<std::string> known;
  for (const auto& each : things) known.push_back(each.name.value);
  undefined(name.span, fmt::format("there is no {} called `{}`", kind, name.value), name.value, known);
}

std::optional<GroupId> Names::group(const Word& name) {
  if (const auto found = model.find_group(name.value)) return found;
  undefined(name, "group", model.groups);
  return std::nullopt;
}

std::optional<StateId> Names::state(const Word& name) {
  if (const auto found = model.find_state(name.value)) return found;
  undefined(name, "state", model.states);
  return std::nullopt;
}

std::optional<std::int64_t> Names::value(StateId id, const Word& value) {
  const State& of = model.states[id];
  const auto number = of.value_of(value.value);
  if (!number) findings_.push_back(no_such_value(of, value, findings_.size()));
  return number;
}

std::optional<Setting> Names::setting(const dsl::SettingSpec& spec) {
  const std::optional<StateId> id = state(spec.state);
  if (!id) return std::nullopt;
  const std::optional<std::int64_t> number = value(*id, spec.value);
  if (!number) return std::nullopt;
  return Setting{*id, *number};
}

std::optional<ProviderId> Names::provider(GroupId id, const Word& name) {
  const Group& of = model.groups[id];
  std::vector<std::string> known;
  for (const ProviderId each : of.providers) {
    if (model.providers[each].name == name.value) return each;
    known.push_back(model.providers[each].name);
  }
  undefined(name.span, fmt::format("the group `{}` has no provider called `{}`", of.name.value, name.value), name.value,
            known);
  return std::nullopt;
}

std::optional<TriggerId> Names::trigger(const Word& name, bool declared) {
  std::vector<std::string> known;
  for (const TriggerId id : model.triggers.ids()) {
    const Trigger& each = model.triggers[id];
    if (declared && each.promise) continue;
    if (each.name == name.value) return id;
    known.push_back(each.name);
  }
  undefined(name.span, fmt::format("there is no trigger called `{}`", name.value), name.value, known);
  return std::nullopt;
}

std::optional<std::uint32_t> Names::level(const Task& task, const std::optional<Word>& name) {
  if (!name) return task.levels.front().level;
  std::vector<std::string> known;
  for (const Task::NamedLevel& each : task.levels) {
    if (each.name == name->value) return each.level;
    if (!each.name.empty()) known.push_back(each.name);
  }
  undefined(name->span,
            fmt::format("the task `{}` has no level called `{}`", model.groups[task.target].name.value, name->value),
            name->value, known)
      .notes.push_back({task.span, known.empty() ? "it is declared here, without levels" : "it is declared here"});
  return std::nullopt;
}

const Task* Names::task(const std::vector<Task>& tasks, std::string_view owner, const Word& name) {
  const std::optional<GroupId> target = model.find_group(name.value);
  std::vector<std::string> known;
  for (const Task& each : tasks) {
    if (target == each.target) return &each;
    known.push_back(model.groups[each.target].name.value);
  }
  Diagnostic& fault = undefined(name.span,
                                target ? fmt::format("{} no task called `{}`", owner, name.value)
                                       : fmt::format("there is no group called `{}`", name.value),
                                name.value, known);
  // `Walk(3)` and `Walk.halting`.
  const std::size_t end = std::min(name.value.find_first_of("(."), name.value.size());
  const std::string task = name.value.substr(0, end);
  if (end == name.value.size() || std::find(known.begin(), known.end(), task) == known.end()) return nullptr;
  if (name.value[end] == '.')
    fault.help = fmt::format("a request names the group, `{}`: its provider is chosen by `when` and `needs`", task);
  else if (name.value.ends_with(')'))
    fault.help = fmt::format("data belongs in `data`: `{{{}: {{data: {}}}}}`", task,
                             name.value.substr(end + 1, name.value.size() - end - 2));
  return nullptr;
}

std::optional<RequestedTask> Names::request(const std::vector<Task>& tasks, std::string_view owner,
                                            const dsl::RequestSpec& spec) {
  const Task* found = task(tasks, owner, spec.group);
  if (found == nullptr) return std::nullopt;
  const std::optional<std::uint32_t> at = level(*found, spec.level);
  if (!at) return std::nullopt;
  RequestedTask out{found->edge, *at, std::nullopt, spec.keep.value};
  if (spec.data) out.data = spec.data->value;
  return out;
}

} // namespace director::compiler
