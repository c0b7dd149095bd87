#pragma once
// SPDX-License-Identifier: MIT
// Resolves the names in a scenario. An unknown name is reported to the list that was given at construction.

#include "compiler/play/scenario/scenario.hpp"

#include <string_view>

namespace director::compiler {

class Names {
public:
  Names(const Model& of, std::vector<dsl::Diagnostic>& findings) : model(of), findings_(findings) {}

  std::optional<GroupId> group(const Word& name);
  std::optional<StateId> state(const Word& name);
  std::optional<std::int64_t> value(StateId state, const Word& value);
  std::optional<Setting> setting(const dsl::SettingSpec& spec);
  std::optional<ProviderId> provider(GroupId group, const Word& name);
  /// A trigger with a listener; `declared`: not a promise.
  std::optional<TriggerId> trigger(const Word& name, bool declared);
  /// The index of a level among Edge::levels; without a name the first of the task.
  std::optional<std::uint32_t> level(const Task& task, const std::optional<Word>& name);
  /// One of `tasks`, which belong to `owner` ("`Walk.walking` requests no group called").
  const Task* task(const std::vector<Task>& tasks, std::string_view owner, const Word& name);
  std::optional<RequestedTask> request(const std::vector<Task>& tasks, std::string_view owner,
                                       const dsl::RequestSpec& spec);

  dsl::Diagnostic& error(std::string_view id, Span span, std::string message, std::string help);
  /// Reports undefined_name, with the nearest of `known` as its help, or with all of them.
  dsl::Diagnostic& undefined(Span span, std::string message, std::string_view name,
                             const std::vector<std::string>& known);

  const Model& model;

private:
  /// Of things that have a name.
  template <class Things>
  void undefined(const Word& name, std::string_view kind, const Things& things);

  std::vector<dsl::Diagnostic>& findings_;
};

} // namespace director::compiler
