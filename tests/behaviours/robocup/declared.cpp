// Header: tests/behaviours/robocup/declared.hpp. Test: tests/behaviours/robocup/robocup_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/behaviours/robocup/declared.hpp"

#include "dsl/reading/read_behaviour.hpp"
#include "dsl/source/render.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace director::tests {

namespace {

std::vector<std::string> texts(const std::vector<dsl::Word>& words) {
  std::vector<std::string> texts;
  for (const dsl::Word& word : words) texts.push_back(word.value);
  return texts;
}

std::string text_of(const dsl::ConditionSpec& condition) {
  constexpr std::string_view signs[] = {"==", "!=", "<", "<=", ">", ">="};
  std::string text = condition.state.value;
  if (condition.any) return text;
  text += " " + std::string(signs[static_cast<std::size_t>(condition.op.value)]) + " ";
  for (const dsl::Word& value : condition.values)
    text += (&value == &condition.values.front() ? "" : "|") + value.value;
  return text;
}

std::vector<std::string> texts(const std::vector<dsl::ConditionSpec>& conditions) {
  std::vector<std::string> texts;
  for (const dsl::ConditionSpec& condition : conditions) texts.push_back(text_of(condition));
  return texts;
}

std::vector<std::string> sorted(std::vector<std::string> words) {
  std::sort(words.begin(), words.end());
  return words;
}

Ask ask_of(const dsl::TaskSpec& task) {
  Ask ask{task.name.value, {}, task.levels.front().optional.value};
  for (const dsl::LevelSpec& level : task.levels) {
    ask.priorities.push_back(level.priority.value);
    CHECK_FALSE(level.apart.value); // a word that the team does not know
  }
  return ask;
}

std::vector<Ask> asks_of(const std::vector<dsl::TaskSpec>& tasks) {
  std::vector<Ask> asks;
  for (const dsl::TaskSpec& task : tasks) asks.push_back(ask_of(task));
  return asks;
}

Provider declared_provider(const dsl::ProviderSpec& spec) {
  Provider provider;
  provider.when = texts(spec.when);
  provider.needs = texts(spec.needs);
  provider.causing = texts(spec.causing);
  provider.uses = texts(spec.uses);
  provider.triggers = texts(spec.triggers);
  provider.sets = sorted(texts(spec.sets));
  if (spec.every) provider.every_us = spec.every->value.microseconds();
  provider.flat = spec.tasks.has_value();
  if (spec.tasks) provider.packs.push_back(asks_of(*spec.tasks));
  if (spec.packs)
    for (const dsl::PackSpec& pack : *spec.packs) provider.packs.push_back(asks_of(pack.tasks));
  CHECK(spec.stay.empty());
  return provider;
}

Group declared_group(const dsl::GroupSpec& spec) {
  Group group{
      spec.name.value, spec.layer.value_or(dsl::Word{}).value, spec.module.value_or(dsl::Word{}).value, {}, {}, {}};
  if (spec.start) group.start = sorted(texts(spec.start->sets));
  if (spec.stop) group.stop = sorted(texts(spec.stop->sets));
  for (const dsl::ProviderSpec& provider : spec.providers) group.providers.push_back(declared_provider(provider));
  return group;
}

State state_of(const dsl::StateSpec& spec) {
  return {spec.name.value,
          spec.type.value_or(dsl::Word{}).value,
          texts(spec.values.value_or(std::vector<dsl::Word>{})),
          texts(spec.unordered),
          spec.initial.value_or(dsl::Word{}).value,
          spec.external.value};
}

// The file itself, without what it imports.
dsl::BehaviourSpec read_file_of(const std::filesystem::path& path) {
  dsl::DiskFiles disk;
  dsl::Sources sources;
  dsl::ReadResult result = dsl::read_behaviour(path.string(), disk, sources);
  INFO(dsl::render(result.diagnostics, sources));
  REQUIRE(result.diagnostics.empty());
  REQUIRE_FALSE(result.spec.files.empty());
  return std::move(result.spec.files.back());
}

void read_modules(const std::filesystem::path& folder, TeamGraph& graph) {
  for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(folder)) {
    const dsl::BehaviourSpec file = read_file_of(entry.path());
    CHECK_FALSE(file.roots); // then it would be a deployment
    CHECK(file.name.value == entry.path().stem().string());
    if (entry.path().stem() == "common") {
      for (const dsl::StateSpec& state : file.states) graph.states.push_back(state_of(state));
      graph.triggers = sorted(texts(file.triggers));
      continue;
    }
    Module module{entry.path().stem().string(), sorted(texts(file.externs)), {}};
    for (const dsl::GroupSpec& group : file.groups) module.groups.push_back(declared_group(group));
    CHECK(file.states.empty());
    CHECK(file.extend.empty());
    graph.modules.push_back(std::move(module));
  }
}

bool is_role(const std::filesystem::path& below) {
  const std::string name = below.string();
  return name.ends_with(".yaml") && !name.ends_with(".scenario.yaml") && *below.begin() != "modules" &&
         *below.begin() != "older";
}

void read_roles(const std::filesystem::path& folder, TeamGraph& graph) {
  for (const std::filesystem::directory_entry& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::filesystem::path below = std::filesystem::relative(entry.path(), folder);
    if (!is_role(below)) continue;
    const dsl::BehaviourSpec file = read_file_of(entry.path());
    Role role{(below.parent_path() / below.stem()).generic_string(), {}, {}};
    for (const dsl::ImportSpec& import : file.imports) role.imports.push_back(import.path.value);
    REQUIRE(file.roots);
    role.roots = asks_of(*file.roots);
    CHECK(file.groups.empty());
    std::string name = role.name;
    std::replace(name.begin(), name.end(), '/', '_');
    CHECK(file.name.value == name);
    graph.roles.push_back(std::move(role));
  }
}

} // namespace

TeamGraph read_declared(const std::filesystem::path& folder) {
  TeamGraph graph;
  read_modules(folder / "modules", graph);
  read_roles(folder, graph);
  std::sort(graph.modules.begin(), graph.modules.end(),
            [](const Module& a, const Module& b) { return a.name < b.name; });
  std::sort(graph.roles.begin(), graph.roles.end(), [](const Role& a, const Role& b) { return a.name < b.name; });
  return graph;
}

} // namespace director::tests
