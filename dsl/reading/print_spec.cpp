// Header: dsl/reading/print_spec.hpp. Test: tests/dsl/reading/print_spec_test.cpp.
// SPDX-License-Identifier: MIT
//
// A function that returns Pairs returns the `key: value` texts of one mapping; the caller that prints the mapping
// decides between braces and separate lines.
#include "dsl/reading/print_spec.hpp"

#include "dsl/reading/read_condition.hpp"
#include "dsl/yaml/yaml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace director::dsl {

namespace {

using Pairs = std::vector<std::string>;

std::string pair(std::string_view key, std::string_view value) { return fmt::format("{}: {}", yaml_word(key), value); }

void add(Pairs& pairs, std::string_view key, const std::optional<Word>& word) {
  if (word) pairs.push_back(pair(key, yaml_word(word->value)));
}

void add(Pairs& pairs, std::string_view key, const Located<bool>& flag) {
  if (flag.value) pairs.push_back(pair(key, "true"));
}

std::string list(const std::vector<Word>& words) {
  std::vector<std::string> out;
  for (const Word& word : words) out.push_back(yaml_word(word.value));
  return yaml_list(out);
}

void add(Pairs& pairs, std::string_view key, const std::vector<Word>& words) {
  if (!words.empty()) pairs.push_back(pair(key, list(words)));
}

void add(Pairs& pairs, std::string_view key, const std::vector<ConditionSpec>& conditions) {
  std::vector<std::string> out;
  for (const ConditionSpec& condition : conditions) out.push_back(yaml_word(to_text(condition)));
  if (!out.empty()) pairs.push_back(pair(key, yaml_list(out)));
}

void add(Pairs& pairs, const std::vector<AllowSpec>& allow) {
  if (allow.empty()) return;
  std::vector<Word> ids;
  for (const AllowSpec& one : allow) ids.push_back(one.id);
  add(pairs, "allow", ids);
  add(pairs, "because", allow.front().because);
}

/// Lines of a block mapping below `key`; `key: {}` if there are none.
void block(std::string& out, std::size_t indentation, std::string_view key, const Pairs& pairs) {
  if (pairs.empty()) {
    out += fmt::format("{:{}}{}: {{}}\n", "", indentation, yaml_word(key));
    return;
  }
  out += fmt::format("{:{}}{}:\n", "", indentation, yaml_word(key));
  for (const std::string& line : pairs) out += fmt::format("{:{}}{}\n", "", indentation + 2, line);
}

Pairs level_pairs(const LevelSpec& level) {
  Pairs pairs;
  if (level.priority.value != 0) pairs.push_back(pair("priority", std::to_string(level.priority.value)));
  add(pairs, "optional", level.optional);
  add(pairs, "apart", level.apart);
  return pairs;
}

Pairs task_pairs(const TaskSpec& task) {
  Pairs pairs;
  if (task.levels.size() == 1 && task.levels.front().name.value.empty()) {
    pairs = level_pairs(task.levels.front());
  } else {
    Pairs levels;
    for (const LevelSpec& level : task.levels)
      levels.push_back(pair(level.name.value, yaml_mapping(level_pairs(level))));
    pairs.push_back(pair("levels", yaml_mapping(levels)));
  }
  add(pairs, "doc", task.doc);
  add(pairs, task.allow);
  return pairs;
}

Pairs tasks_pairs(const std::vector<TaskSpec>& tasks) {
  Pairs pairs;
  for (const TaskSpec& task : tasks) pairs.push_back(pair(task.name.value, yaml_mapping(task_pairs(task))));
  return pairs;
}

/// A list, if the tasks have nothing but names.
std::string tasks_text(const std::vector<TaskSpec>& tasks) {
  const bool bare =
      std::all_of(tasks.begin(), tasks.end(), [](const TaskSpec& task) { return task_pairs(task).empty(); });
  if (!bare) return yaml_mapping(tasks_pairs(tasks));
  std::vector<Word> names;
  for (const TaskSpec& task : tasks) names.push_back(task.name);
  return list(names);
}

Pairs provider_pairs(const ProviderSpec& provider) {
  Pairs pairs;
  add(pairs, "when", provider.when);
  add(pairs, "stay", provider.stay);
  add(pairs, "needs", provider.needs);
  add(pairs, "causing", provider.causing);
  add(pairs, "sets", provider.sets);
  add(pairs, "uses", provider.uses);
  add(pairs, "triggers", provider.triggers);
  if (provider.every) pairs.push_back(pair("every", to_text(provider.every->value)));
  if (provider.tasks) pairs.push_back(pair("tasks", tasks_text(*provider.tasks)));
  if (provider.packs) {
    Pairs packs;
    for (const PackSpec& pack : *provider.packs) packs.push_back(pair(pack.name.value, tasks_text(pack.tasks)));
    pairs.push_back(pair("packs", yaml_mapping(packs)));
  }
  return pairs;
}

/// Lines of `providers:`, each provider a list entry.
Pairs providers_lines(const std::vector<ProviderSpec>& providers) {
  if (providers.empty()) return {"providers: []"};
  Pairs lines{"providers:"};
  for (const ProviderSpec& provider : providers) {
    Pairs pairs{pair("name", yaml_word(provider.name.value))};
    add(pairs, "doc", provider.doc);
    for (std::string& words : provider_pairs(provider)) pairs.push_back(std::move(words));
    add(pairs, provider.allow);
    for (std::size_t i = 0; i < pairs.size(); ++i) lines.push_back((i == 0 ? "  - " : "    ") + pairs[i]);
  }
  return lines;
}

void add_handler(Pairs& pairs, std::string_view key, const std::optional<HandlerSpec>& handler) {
  Pairs sets;
  if (!handler) return;
  add(sets, "sets", handler->sets);
  pairs.push_back(pair(key, sets.empty() ? "true" : yaml_mapping(sets)));
}

Pairs group_lines(const GroupSpec& group) {
  Pairs lines;
  add(lines, "doc", group.doc);
  add(lines, "layer", group.layer);
  add(lines, "module", group.module);
  add(lines, "data", group.data);
  add(lines, "realtime", group.realtime);
  add_handler(lines, "start", group.start);
  add_handler(lines, "stop", group.stop);
  add(lines, "uses", group.uses);
  add(lines, "sets", group.sets);
  add(lines, "triggers", group.triggers);
  const bool direct = group.providers.size() == 1 && group.providers.front().direct;
  for (std::string& line : direct ? provider_pairs(group.providers.front()) : providers_lines(group.providers))
    lines.push_back(std::move(line));
  add(lines, group.allow);
  return lines;
}

Pairs extend_lines(const ExtendSpec& extend) {
  Pairs lines;
  add(lines, "doc", extend.doc);
  add(lines, "before", extend.before);
  for (std::string& line : providers_lines(extend.providers)) lines.push_back(std::move(line));
  return lines;
}

Pairs state_pairs(const StateSpec& state) {
  Pairs pairs;
  add(pairs, "doc", state.doc);
  add(pairs, "type", state.type);
  if (state.values) pairs.push_back(pair("values", list(*state.values)));
  add(pairs, "unordered", state.unordered);
  if (state.range)
    pairs.push_back(pair("range", fmt::format("[{}, {}]", state.range->low.value, state.range->high.value)));
  add(pairs, "initial", state.initial);
  add(pairs, "external", state.external);
  if (state.expires) {
    Pairs expires{pair("after", to_text(state.expires->after.value))};
    add(expires, "to", state.expires->to);
    pairs.push_back(pair("expires", yaml_mapping(expires)));
  }
  add(pairs, "of", state.of);
  add(pairs, state.allow);
  return pairs;
}

std::string assertion_text(const AssertionSpec& assertion) {
  const auto name = [&](std::size_t i) { return yaml_word(assertion.groups[i].value); };
  switch (assertion.kind.value) {
  case AssertionSpec::Kind::never_together: return fmt::format("never_together: {}", list(assertion.groups));
  case AssertionSpec::Kind::beats: return fmt::format("beats: {{{}: {}}}", name(0), name(1));
  case AssertionSpec::Kind::can_run: return fmt::format("can_run: {}", name(0));
  case AssertionSpec::Kind::soft: return fmt::format("soft: {{from: {}, to: {}}}", name(0), name(1));
  }
  return "";
}

Pairs head_lines(const BehaviourSpec& file) {
  Pairs lines{pair("behaviour", yaml_word(file.name.value)), "language: 1"};
  add(lines, "doc", file.doc);
  std::vector<Word> imports;
  for (const ImportSpec& import : file.imports) imports.push_back(import.path);
  add(lines, "imports", imports);
  Pairs cpp;
  add(cpp, "namespace", file.cpp.name_space);
  add(cpp, "headers", file.cpp.headers);
  if (!cpp.empty()) lines.push_back(pair("cpp", yaml_mapping(cpp)));
  add(lines, "layers", file.layers);
  return lines;
}

} // namespace

std::string print_file(const BehaviourSpec& file) {
  std::string out;
  const auto print_lines = [&](const Pairs& lines) {
    for (const std::string& line : lines) out += line + "\n";
  };
  print_lines(head_lines(file));
  Pairs states, names;
  for (const StateSpec& state : file.states) states.push_back(pair(state.name.value, yaml_mapping(state_pairs(state))));
  if (!states.empty()) block(out, 0, "states", states);
  add(names, "triggers", file.triggers);
  add(names, "extern", file.externs);
  print_lines(names);
  if (file.roots) block(out, 0, "roots", tasks_pairs(*file.roots));
  if (!file.groups.empty()) out += "groups:\n";
  for (const GroupSpec& group : file.groups) block(out, 2, group.name.value, group_lines(group));
  if (!file.extend.empty()) out += "extend:\n";
  for (const ExtendSpec& extend : file.extend) block(out, 2, extend.group.value, extend_lines(extend));
  if (!file.assertions.empty()) out += "assertions:\n";
  for (const AssertionSpec& assertion : file.assertions) out += fmt::format("  - {}\n", assertion_text(assertion));
  Pairs tail;
  Pairs limits;
  if (file.limits.trials) limits.push_back(fmt::format("trials: {}", file.limits.trials->value));
  if (file.limits.pass) limits.push_back(fmt::format("pass: {}", file.limits.pass->value));
  if (!limits.empty()) tail.push_back(pair("limits", yaml_mapping(limits)));
  add(tail, file.allow);
  print_lines(tail);
  return out;
}

std::string print_spec(const Spec& spec, const Sources& sources) {
  std::string out;
  for (const BehaviourSpec& file : spec.files)
    out += fmt::format("--- # {}\n{}", sources[file.file].path(), print_file(file));
  return out;
}

} // namespace director::dsl
