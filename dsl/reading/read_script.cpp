// Header: dsl/reading/read_script.hpp. Test: tests/dsl/reading/read_scenario_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/reading/read_script.hpp"

#include "dsl/lexical/characters.hpp"
#include "dsl/reading/read_data.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

namespace director::dsl {

namespace {

/// The value of an enum that is written as one of `names`, which are in its order.
template <class Enum, std::size_t size>
std::optional<Located<Enum>> read_choice(Reader& reader, const YamlNode* node, std::string_view subject,
                                         const std::array<std::string_view, size>& names) {
  if (!node) return std::nullopt;
  const auto name = std::find(names.begin(), names.end(), node->text);
  if (node->kind == YamlNode::Kind::scalar && name != names.end())
    return Located<Enum>{static_cast<Enum>(name - names.begin()), node->span};
  reader.unexpected(*node, subject, fmt::format("one of {}", fmt::join(names, ", ")));
  return std::nullopt;
}

constexpr std::array<std::string_view, 5> reasons{"new_task", "pushed", "subtask_done", "wait", "trigger"};
constexpr std::array<std::string_view, 5> use_states{"running", "queued", "none", "done", "failed"};

std::vector<UseGuardSpec> read_use_guards(Reader& reader, const YamlNode* node) {
  std::vector<UseGuardSpec> out;
  if (!reader.is_mapping(node, "uses", "a mapping such as {Kick: done}")) return out;
  for (const YamlPair& pair : node->pairs)
    if (const auto state = read_choice<UseState>(reader, &pair.value, pair.key.value, use_states))
      out.push_back({reader.name(pair), *state});
  return out;
}

/// Reads `done: true` and the like: only true is a value.
bool read_answer_flag(Reader& reader, const YamlNode* node, std::string_view key) {
  const bool is_no =
      node != nullptr && node->kind == YamlNode::Kind::scalar && (node->text == "false" || is_a_no(node->text));
  if (is_no) {
    reader.unexpected(*node, key, "true", "leave it out where it is not so");
    return false;
  }
  const auto flag = reader.flag(node, key, "true");
  return flag && flag->value;
}

void read_answer(Reader& reader, const YamlNode& mapping, CaseSpec& out) {
  static const Keys request_keys{"level", "data", "keep"};
  constexpr std::array<std::string_view, 5> answers{"pack", "tasks", "done", "failed",
                                                    "continue"}; // in the order of Answer
  for (std::size_t i = 0; i < answers.size(); ++i)
    for (std::size_t j = i + 1; j < answers.size(); ++j)
      reader.exclude(mapping, answers[i], answers[j], "a case gives one answer: leave out the others");
  out.answer.span = mapping.span;
  for (std::size_t i = 0; i < answers.size() && out.answer.value == Answer::nothing; ++i)
    if (mapping.find(answers[i])) out.answer = {static_cast<Answer>(i + 1), Reader::key_of(mapping, answers[i]).span};
  out.pack = reader.word(mapping.find("pack"), "pack", "the name of a pack");
  const auto needs_pack = [&](std::string_view key, const char* help) {
    if (mapping.find(key) && reader.lacks(mapping, "pack"))
      reader.error("missing_key", Reader::key_of(mapping, key).span, fmt::format("`{}` needs `pack`", key), help);
  };
  needs_pack("with", "it says more about some tasks of a pack");
  needs_pack("without", "it leaves out some tasks of a pack");
  out.without = reader.words(mapping.find("without"), "without", "the name of a group");
  const std::string_view list = out.answer.value == Answer::pack ? "with" : "tasks";
  out.tasks = read_requests(reader, mapping.find(list), list, request_keys);
  for (const std::string_view key : {"done", "failed", "continue"}) read_answer_flag(reader, mapping.find(key), key);
}

CaseSpec read_case(Reader& reader, const YamlNode& mapping, const Word& entry, bool handler) {
  static const Keys handler_keys{"data", "run", "set"};
  static const Keys keys{"reason", "trigger", "data", "run",  "uses",   "pack",     "tasks",
                         "with",   "without", "set",  "done", "failed", "continue", "wait"};
  CaseSpec out;
  out.span = mapping.span;
  static const Slips no_slips;
  reader.know_keys(mapping, fmt::format("a case of `{}`", entry.value), handler ? handler_keys : keys,
                   handler ? no_slips : slips_of_case());
  out.run = reader.number(mapping.find("run"), "run", {1});
  if (const YamlNode* data = mapping.find("data")) out.data = {read_data(reader, *data, "data"), data->span};
  out.set = read_settings(reader, mapping.find("set"), "set");
  out.answer.span = mapping.span;
  if (handler) return out;
  out.reason = read_choice<Reason>(reader, mapping.find("reason"), "reason", reasons);
  out.trigger = reader.word(mapping.find("trigger"), "trigger", "the name of a trigger");
  out.uses = read_use_guards(reader, mapping.find("uses"));
  out.wait = reader.duration(mapping.find("wait"), "wait");
  read_answer(reader, mapping, out);
  return out;
}

/// For `Legs: 3`, `Legs: [1, 2]` and `Legs: urgent`.
std::string help_for_short_request(const YamlPair& pair) {
  const YamlNode& value = pair.value;
  if (value.kind != YamlNode::Kind::list && value.kind != YamlNode::Kind::scalar) return "";
  const std::string& name = pair.key.value;
  const std::string with_data = fmt::format("`{}: {{data: {}}}`", name, to_text(data_of(value)));
  const bool may_be_level = value.kind == YamlNode::Kind::scalar && is_letter(value.text.empty() ? '0' : value.text[0]);
  return may_be_level ? fmt::format("write {}, or, if it is a level, `{}: {{level: {}}}`", with_data, name, value.text)
                      : "write " + with_data;
}

RequestSpec read_request(Reader& reader, const YamlPair& pair, const Keys& keys) {
  RequestSpec out;
  out.group = reader.name(pair);
  out.keep.span = pair.key.span;
  if (!reader.is_mapping(&pair.value, pair.key.value, "a mapping", help_for_short_request(pair))) return out;
  reader.know_keys(pair.value, fmt::format("a request of `{}`", pair.key.value), keys);
  out.level = reader.word(pair.value.find("level"), "level", "the name of a level");
  if (const YamlNode* data = pair.value.find("data")) out.data = {read_data(reader, *data, "data"), data->span};
  if (std::find(keys.begin(), keys.end(), "keep") != keys.end())
    if (const auto keep = reader.flag(pair.value.find("keep"), "keep")) out.keep = *keep;
  return out;
}

} // namespace

namespace {

bool can_be_name(std::string_view text) { return !text.empty() && std::all_of(text.begin(), text.end(), is_word); }

/// `Battery: 5` for `Battery == 5` and `Battery = 5`; empty for another text.
std::string as_setting(std::string_view text) {
  const std::size_t sign = text.find('=');
  if (sign == std::string_view::npos) return "";
  const std::string_view name = trimmed(text.substr(0, sign));
  const std::string_view value = trimmed(text.substr(sign + (text.substr(sign).starts_with("==") ? 2 : 1)));
  const bool good = can_be_name(name) && can_be_name(value.substr(value.starts_with('-') ? 1 : 0));
  return good ? fmt::format("{}: {}", name, value) : "";
}

/// Split at each comma and `and`.
std::vector<std::string_view> conditions_in(std::string_view text) {
  constexpr std::string_view separator = " and ";
  std::vector<std::string_view> out;
  while (true) {
    const std::size_t comma = text.find(','), word = text.find(separator), end = std::min(comma, word);
    out.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return out;
    text.remove_prefix(end + (word < comma ? separator.size() : 1));
  }
}

/// For `set: Battery == 5` and `set: [Battery == 5, Ball == near]`.
std::string help_for_settings(const YamlNode* node) {
  std::vector<std::string> settings;
  bool compares = false, good = true;
  const auto add = [&](const YamlNode& one) {
    compares = compares || one.text.find_first_of("=<>") != std::string::npos;
    for (const std::string_view part : conditions_in(one.text)) {
      settings.push_back(as_setting(part));
      good = good && !settings.back().empty();
    }
  };
  if (node && node->kind == YamlNode::Kind::scalar) add(*node);
  if (node && node->kind == YamlNode::Kind::list) std::for_each(node->items.begin(), node->items.end(), add);
  if (!compares) return "";
  return good ? fmt::format("write `{{{}}}`", fmt::join(settings, ", ")) : "each state gets one value: `{Ball: near}`";
}

/// For `tasks: {Legs: {}, Kick: {data: 3}}`, as `tasks` are written in a behaviour file.
std::string help_for_requests(const YamlNode* node) {
  if (!node || node->kind != YamlNode::Kind::mapping || node->pairs.empty()) return "";
  std::vector<std::string> entries;
  for (const YamlPair& pair : node->pairs) {
    const bool is_bare = pair.value.pairs.empty() && pair.value.kind != YamlNode::Kind::list &&
                         pair.value.kind != YamlNode::Kind::scalar;
    entries.push_back(is_bare ? pair.key.value : fmt::format("{}: {}", pair.key.value, to_text(data_of(pair.value))));
  }
  return fmt::format("write `[{}]`", fmt::join(entries, ", "));
}

/// For an answer that is written as a word.
std::string help_for_case(const YamlNode& node, bool handler) {
  if (node.kind != YamlNode::Kind::scalar) return "";
  if (handler) return "a handler gives no answer: it may set states, `{set: {Ball: near}}`";
  for (const std::string_view word : {"done", "failed", "continue"})
    if (node.text == word) return fmt::format("write `{{{}: true}}`", word);
  if (const std::string* help = help_for(slips_of_case(), node.text)) return *help;
  if (node.text == "wait") return "write `{wait: 100 ms}`";
  if (!can_be_name(node.text) || is_digit(node.text.front())) return "";
  return fmt::format("write `{{tasks: [{0}]}}` if it is a task, `{{pack: {0}}}` if it is a pack", node.text);
}

} // namespace

std::vector<SettingSpec> read_settings(Reader& reader, const YamlNode* node, std::string_view subject) {
  std::vector<SettingSpec> out;
  if (!reader.is_mapping(node, subject, "a mapping of states to values", help_for_settings(node))) return out;
  for (const YamlPair& pair : node->pairs)
    if (auto value = reader.word(&pair.value, pair.key.value, "a value of the state"))
      out.push_back({reader.name(pair), std::move(*value)});
  return out;
}

std::vector<RequestSpec> read_request_mapping(Reader& reader, const YamlNode& node, const Keys& keys) {
  std::vector<RequestSpec> out;
  for (const YamlPair& pair : node.pairs) out.push_back(read_request(reader, pair, keys));
  return out;
}

std::vector<RequestSpec> read_requests(Reader& reader, const YamlNode* node, std::string_view subject,
                                       const Keys& keys) {
  std::vector<RequestSpec> out;
  if (!reader.is_list(node, subject, "a list", help_for_requests(node))) return out;
  for (const YamlNode& item : node->items) {
    if (item.kind == YamlNode::Kind::mapping)
      for (RequestSpec& request : read_request_mapping(reader, item, keys)) out.push_back(std::move(request));
    else if (auto name = reader.word(&item, subject, "the name of a group, or {Group: {data: 1}}"))
      out.push_back({*name, {}, {}, {false, name->span}});
  }
  return out;
}

std::pair<Word, Word> split_at_dot(const Word& name, bool plain) {
  const std::size_t dot = std::min(name.value.find('.'), name.value.size());
  Word first{name.value.substr(0, dot), name.span}, second{"", name.span};
  if (dot < name.value.size()) second.value = name.value.substr(dot + 1);
  if (plain) { // no quotes or escapes: bytes of the text are bytes of the file
    first.span.end = first.span.begin + static_cast<std::uint32_t>(dot);
    second.span.begin = second.span.end - static_cast<std::uint32_t>(second.value.size());
  }
  return {std::move(first), std::move(second)};
}

ScriptEntrySpec read_script_entry(Reader& reader, const YamlPair& pair) {
  ScriptEntrySpec out;
  out.span = pair.span;
  const Word name = reader.name(pair);
  auto [group, part] = split_at_dot(name, pair.key_style == YamlNode::Style::plain);
  out.group = std::move(group);
  if (name.value.find('.') != std::string::npos) out.part = std::move(part);
  const bool handler = out.part && (out.part->value == "start" || out.part->value == "stop");
  if (pair.value.kind == YamlNode::Kind::mapping) {
    out.cases.push_back(read_case(reader, pair.value, name, handler));
  } else if (reader.is_list(&pair.value, name.value, "a case or a list of cases", help_for_case(pair.value, handler))) {
    for (const YamlNode& item : pair.value.items)
      if (reader.is_mapping(&item, name.value, "a case", help_for_case(item, handler)))
        out.cases.push_back(read_case(reader, item, name, handler));
  }
  return out;
}

} // namespace director::dsl
