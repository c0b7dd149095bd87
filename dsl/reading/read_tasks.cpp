// Header: dsl/reading/read_tasks.hpp. Test: tests/dsl/reading/read_tasks_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/reading/read_tasks.hpp"

#include <fmt/format.h>

#include <limits>
#include <utility>

namespace director::dsl {

namespace {

constexpr Bounds priorities{std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()};

/// A level with its defaults, at the place of the task.
LevelSpec level_at(Span span) { return {{"", span}, {0, span}, {false, span}, {false, span}}; }

void read_priority(Reader& reader, const YamlNode* node, LevelSpec& level) {
  if (const auto number = reader.number(node, "priority", priorities))
    level.priority = {static_cast<std::int32_t>(number->value), number->span};
}

void read_flags(Reader& reader, const YamlNode& mapping, LevelSpec& level) {
  if (const auto flag = reader.flag(mapping.find("optional"), "optional")) level.optional = *flag;
  if (const auto flag = reader.flag(mapping.find("apart"), "apart")) level.apart = *flag;
  if (!level.optional.value || !level.apart.value) return;
  reader.exclude(mapping, "optional", "apart", "leave out `apart`: what is optional waits for itself alone anyway");
  level.apart.value = false;
}

/// For `Walk: 10`, `Walk: optional` and `Walk: true`, of a task or a level.
std::string help_for_short_task(const YamlPair& pair) {
  const YamlNode& value = pair.value;
  const std::string& name = pair.key.value;
  if (value.kind == YamlNode::Kind::list) return "tasks that belong together stand in `packs`: `packs: {go: [Walk]}`";
  if (value.kind != YamlNode::Kind::scalar) return "";
  if (parse_number(value.text)) return fmt::format("write `{}: {{priority: {}}}`", name, value.text);
  for (const std::string_view word : {"optional", "apart"})
    if (value.text == word) return fmt::format("write `{}: {{{}: true}}`", name, word);
  if (value.text == "true") return fmt::format("write `{}: {{}}`", name);
  // A value with blanks may be a key without its colon.
  if (value.text.find(' ') != std::string::npos) return "";
  return fmt::format("a priority is a whole number: `{}: {{priority: 10}}`", name);
}

constexpr const char* example_of_levels = "for example `{normal: {priority: 10}}`";

bool names_a_level(Reader& reader, const YamlNode& mapping, std::string_view subject) {
  if (mapping.pairs.empty())
    reader.error("wrong_node_kind", mapping.span, fmt::format("`{}`: expected at least one level, found none", subject),
                 subject == "levels" ? example_of_levels : "for example `{normal: 10, urgent: 80}`");
  return !mapping.pairs.empty();
}

/// `priority: {normal: 10, urgent: 80}`: each level has the other keys of the task.
std::vector<LevelSpec> read_priorities(Reader& reader, const YamlNode& mapping, const LevelSpec& model) {
  std::vector<LevelSpec> levels;
  for (const YamlPair& pair : mapping.pairs) {
    LevelSpec level = model;
    level.name = reader.name(pair);
    read_priority(reader, &pair.value, level);
    levels.push_back(std::move(level));
  }
  return levels;
}

/// `levels: {firm: {priority: 50}, spare: {priority: 50, optional: true}}`.
std::vector<LevelSpec> read_levels(Reader& reader, const YamlNode& mapping) {
  static const Keys keys{"priority", "optional", "apart"};
  std::vector<LevelSpec> levels;
  for (const YamlPair& pair : mapping.pairs) {
    LevelSpec level = level_at(pair.key.span);
    level.name = reader.name(pair);
    if (reader.is_mapping(&pair.value, pair.key.value, "a mapping", help_for_short_task(pair))) {
      reader.know_keys(pair.value, fmt::format("level `{}`", pair.key.value), keys);
      read_priority(reader, pair.value.find("priority"), level);
      read_flags(reader, pair.value, level);
    }
    levels.push_back(std::move(level));
  }
  return levels;
}

void read_entry(Reader& reader, const YamlNode& mapping, TaskSpec& task) {
  static const Keys keys{"priority", "optional", "apart", "levels", "doc", "allow", "because"};
  reader.know_keys(mapping, fmt::format("task `{}`", task.name.value), keys, slips_of_task());
  for (const std::string_view other : {"priority", "optional", "apart"})
    reader.exclude(mapping, "levels", other, fmt::format("say `{}` in each of the levels", other));
  LevelSpec& level = task.levels.front();
  read_flags(reader, mapping, level);
  const YamlNode* priority = mapping.find("priority");
  if (priority && priority->kind == YamlNode::Kind::mapping) {
    if (names_a_level(reader, *priority, "priority"))
      task.levels = read_priorities(reader, *priority, LevelSpec(level));
  } else {
    read_priority(reader, priority, level);
  }
  if (const YamlNode* levels = mapping.find("levels"))
    if (reader.is_mapping(levels, "levels", "a mapping", "", example_of_levels) &&
        names_a_level(reader, *levels, "levels"))
      task.levels = read_levels(reader, *levels);
  task.doc = reader.text(mapping.find("doc"), "doc");
  task.allow = read_allow(reader, mapping);
}

} // namespace

std::vector<AllowSpec> read_allow(Reader& reader, const YamlNode& mapping) {
  const YamlNode* allow = mapping.find("allow");
  const YamlNode* because = mapping.find("because");
  if (allow && !because)
    reader.error("missing_key", Reader::key_of(mapping, "allow").span, "`allow` needs `because`",
                 "say why it is wanted: `because: ...`");
  if (because && !allow)
    reader.error("missing_key", Reader::key_of(mapping, "because").span, "`because` needs `allow`",
                 "say which check it is about, `allow: [...]`, or write it as `doc`");
  const std::optional<Word> reason = reader.text(because, "because");
  if (reason && reason->value.find_first_not_of(" \t\r\n") == std::string::npos)
    reader.unexpected(*because, "because", "a reason", "say why it is wanted: `because: ...`");
  std::vector<AllowSpec> out;
  for (Word& id : reader.words(allow, "allow", "the id of a check")) out.push_back({std::move(id), reason});
  return out;
}

std::optional<std::vector<TaskSpec>> read_tasks(Reader& reader, const YamlNode* node, std::string_view subject) {
  if (!node) return std::nullopt;
  std::vector<TaskSpec> tasks;
  const auto add = [&](Word name, Span span) -> TaskSpec& {
    const Span place = name.span;
    tasks.push_back({std::move(name), {level_at(place)}, {}, {}, span});
    return tasks.back();
  };
  if (node->kind == YamlNode::Kind::mapping) {
    for (const YamlPair& pair : node->pairs) {
      TaskSpec& task = add(reader.name(pair), pair.span);
      if (reader.is_mapping(&pair.value, pair.key.value, "a mapping", help_for_short_task(pair)))
        read_entry(reader, pair.value, task);
    }
    return tasks;
  }
  if (!reader.is_list(node, subject, "a list of groups or a mapping")) return std::nullopt;
  for (const YamlNode& item : node->items) {
    if (item.kind == YamlNode::Kind::mapping)
      reader.unexpected(item, subject, "the name of a group",
                        "where a task has words of its own, all are a mapping: {Legs: {}, Head: {optional: true}}");
    else if (auto name = reader.word(&item, subject, "the name of a group"))
      add(std::move(*name), item.span);
  }
  return tasks;
}

std::optional<std::vector<PackSpec>> read_packs(Reader& reader, const YamlNode* node) {
  const bool list = node && node->kind == YamlNode::Kind::list;
  if (!reader.is_mapping(node, "packs", "a mapping of names to tasks",
                         list ? "give each pack a name: `packs: {attack: [Kick, Walk]}`" : "",
                         "for example `{attack: [Kick, Walk]}`; or leave `packs` out"))
    return std::nullopt;
  if (node->pairs.empty())
    reader.error("missing_key", node->span, "`packs` needs a pack",
                 "each run requests one of them, whole: for example `{attack: [Kick, Walk]}`; or leave `packs` out");
  std::vector<PackSpec> packs;
  for (const YamlPair& pair : node->pairs) {
    PackSpec pack{reader.name(pair), {}, pair.span};
    if (auto tasks = read_tasks(reader, &pair.value, pair.key.value)) pack.tasks = std::move(*tasks);
    packs.push_back(std::move(pack));
  }
  return packs;
}

} // namespace director::dsl
