// Header: compiler/explore/scenario/scenario_words.hpp. Test: tests/compiler/explore/verdict_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/explore/scenario/scenario_words.hpp"

#include "dsl/yaml/yaml_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace director::compiler {

std::string ScenarioWords::provider(Index index) const {
  const ProviderId id{index};
  return m_.group_of(id).name.value + "." + m_.providers[id].name;
}

std::string ScenarioWords::request(const RequestedPack& pack) const {
  std::vector<std::string> words;
  for (const RequestedLevel& request : pack) words.push_back(request_entry(m_.roots, request, false));
  return words.size() == 1 && words.front().find(':') == std::string::npos
             ? "request: " + words.front()
             : fmt::format("request: [{}]", fmt::join(words, ", "));
}

std::string ScenarioWords::set(const Puts& puts) const {
  std::vector<std::string> out;
  for (const Put& put : puts) {
    const State& state = m_.states[StateId{put.state}];
    out.push_back(fmt::format("{}: {}", dsl::yaml_word(state.name.value), dsl::yaml_word(state.value_text(put.value))));
  }
  return fmt::format("set: {{{}}}", fmt::join(out, ", "));
}

const Puts& ScenarioWords::puts_of(const Action& action) const {
  switch (action.kind) {
  case Action::Kind::start: return g_.starting[action.group][action.puts];
  case Action::Kind::stop: return g_.stopping[action.group][action.puts];
  case Action::Kind::run: break;
  }
  return g_.bodies[action.provider].puts[action.puts];
}

std::pair<std::string, std::vector<std::string>> ScenarioWords::effects(const Action& action) const {
  const bool runs = action.kind == Action::Kind::run;
  std::vector<std::string> words;
  if (runs) {
    const FreeBody& body = g_.bodies[action.provider];
    const Provider& row = m_.providers[ProviderId{action.provider}];
    switch (action.answer) {
    case Action::Answer::keep: words.emplace_back("continue: true"); break;
    case Action::Answer::done: words.emplace_back("done: true"); break;
    case Action::Answer::pack:
    case Action::Answer::kept:
      answer(row, body.packs[action.pack], action.answer == Action::Answer::kept, words);
      break;
    }
  }
  if (!puts_of(action).empty()) words.push_back(set(puts_of(action)));
  const std::string name = runs ? provider(action.provider)
                                : group(action.group) + (action.kind == Action::Kind::start ? ".start" : ".stop");
  return {name, words};
}

std::string ScenarioWords::request_entry(const std::vector<Task>& tasks, const RequestedLevel& request,
                                         bool keep) const {
  std::vector<std::string> words;
  for (const Task& task : tasks) {
    if (task.edge.value != request.edge) continue;
    const Index level = request.level - g_.tables.edges[request.edge].levels.begin;
    for (std::size_t i = 1; i < task.levels.size() && task.levels.front().level != level; ++i) {
      if (task.levels[i].level == level) words = {"level: " + dsl::yaml_word(task.levels[i].name)};
    }
  }
  if (keep) words.emplace_back("keep: true");
  const std::string name = dsl::yaml_word(group(g_.tables.edges[request.edge].target));
  return words.empty() ? name : fmt::format("{}: {{{}}}", name, fmt::join(words, ", "));
}

void ScenarioWords::answer(const Provider& row, const RequestedPack& requests, bool kept,
                           std::vector<std::string>& words) const {
  if (row.packs.empty()) return;
  const Pack* pack = &row.packs.front();
  std::vector<std::string> entries;
  if (row.has_packs) {
    const auto has = [&](const Task& task, const RequestedLevel& request) {
      const Index level = request.level - g_.tables.edges[request.edge].levels.begin;
      return request.edge == task.edge.value &&
             std::any_of(task.levels.begin(), task.levels.end(),
                         [&](const Task::NamedLevel& named) { return named.level == level; });
    };
    // The pack of which the fewest entries are left out.
    std::size_t fewest = 0;
    bool found = false;
    for (const Pack& each : row.packs) {
      if (each.tasks.size() < requests.size() || (found && each.tasks.size() >= fewest)) continue;
      auto next = requests.begin();
      const bool rest_optional = std::all_of(each.tasks.begin(), each.tasks.end(), [&](const Task& task) {
        if (next == requests.end() || !has(task, *next)) return m_.may_be_left_out(task);
        ++next;
        return true;
      });
      if (next != requests.end() || !rest_optional) continue;
      found = true;
      fewest = each.tasks.size();
      pack = &each;
    }
    words.push_back("pack: " + dsl::yaml_word(pack->name));
    for (const RequestedLevel& request : requests) {
      const std::string word = request_entry(pack->tasks, request, kept);
      if (word.find(':') != std::string::npos) entries.push_back(word);
    }
    if (!entries.empty()) words.push_back(fmt::format("with: [{}]", fmt::join(entries, ", ")));
    std::vector<std::string> left_out;
    for (const Task& task : pack->tasks) {
      if (std::none_of(requests.begin(), requests.end(), [&](const auto& request) { return has(task, request); }))
        left_out.push_back(dsl::yaml_word(m_.groups[task.target].name.value));
    }
    if (!left_out.empty()) words.push_back(fmt::format("without: [{}]", fmt::join(left_out, ", ")));
    return;
  }
  for (const RequestedLevel& request : requests) entries.push_back(request_entry(pack->tasks, request, kept));
  words.push_back(fmt::format("tasks: [{}]", fmt::join(entries, ", ")));
}

} // namespace director::compiler
