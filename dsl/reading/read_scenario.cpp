// Header: dsl/reading/read_scenario.hpp. Test: tests/dsl/reading/read_scenario_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/reading/read_scenario.hpp"

#include "dsl/lexical/characters.hpp"
#include "dsl/reading/read_data.hpp"
#include "dsl/reading/read_script.hpp"
#include "dsl/source/load_file.hpp"
#include "dsl/yaml/yaml_tree.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace director::dsl {

namespace {

const Keys& input_words() { // in the order of InputSpec::Kind
  static const Keys words{"request", "cancel", "set", "trigger", "enable", "disable"};
  return words;
}

Keys with(Keys keys, std::initializer_list<std::string> more) {
  keys.insert(keys.end(), more);
  return keys;
}

/// What to do with two words in one step, or in one entry of `inputs`.
std::string help_for_two(std::string_view first, std::string_view second, bool in_step) {
  if (!in_step) return "make two entries of them";
  if (first == "advance" || second == "advance") return "make two steps of them";
  if (second == "inputs") return fmt::format("make two steps of them, or write `{}` as an entry of `inputs`", first);
  return "make two steps of them, or `inputs: [...]` where they come at once";
}

/// Returns the only one of `words` among the keys of the mapping; reports if there is none or more than one. Does not
/// report if the mapping has a key that is not in `keys`: that was reported, and is probably a misspelt one of `words`.
std::optional<std::size_t> only_word(Reader& reader, const YamlNode& mapping, std::string_view thing, const Keys& words,
                                     const Keys& keys) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!mapping.find(words[i])) continue;
    if (found)
      reader.exclude(mapping, words[*found], words[i], help_for_two(words[*found], words[i], thing == "a step"));
    else
      found = i;
  }
  const bool all_known = std::all_of(mapping.pairs.begin(), mapping.pairs.end(), [&](const YamlPair& pair) {
    return std::find(keys.begin(), keys.end(), pair.key.value) != keys.end();
  });
  if (!found && all_known)
    reader.error("missing_key", mapping.pairs.empty() ? mapping.span : mapping.pairs.front().key.span,
                 fmt::format("{} needs one of {}", thing, fmt::join(words, ", ")), "for example `request: Walk`");
  return found;
}

/// Reads a root, a list of roots, or `{Kick: {level: urgent, data: 1}}`.
std::vector<RequestSpec> read_root_requests(Reader& reader, const YamlNode& node) {
  static const Keys keys{"level", "data"};
  if (node.kind == YamlNode::Kind::mapping) return read_request_mapping(reader, node, keys);
  if (node.kind == YamlNode::Kind::list) return read_requests(reader, &node, "request", keys);
  auto name = reader.word(&node, "request", "a root, a list or a mapping of roots");
  if (!name) return {};
  return {{*name, {}, {}, {false, name->span}}};
}

/// For `cancel: [A, B]`: an input has one.
std::string help_for_names(const YamlNode& list, std::string_view word) {
  const bool named = !list.items.empty() && list.items.front().kind == YamlNode::Kind::scalar;
  const std::string_view first = named ? std::string_view(list.items.front().text) : "...";
  if (named && list.items.size() == 1) return fmt::format("an input has one: write `{}: {}`", word, first);
  return fmt::format("an input has one: for several at once write `inputs: [{{{0}: {1}}}, {{{0}: ...}}]`", word, first);
}

/// `cancel: Walk`.
Word read_one_name(Reader& reader, const YamlNode& node, std::string_view word, std::string_view expected) {
  if (node.kind != YamlNode::Kind::list) return reader.word(&node, word, expected).value_or(Word{});
  reader.unexpected(node, word, expected, help_for_names(node, word));
  return {};
}

/// `Walk.halting`.
void read_provider_name(Reader& reader, const YamlNode& node, InputSpec& input, std::string_view word) {
  constexpr std::string_view expected = "a provider such as Walk.halting";
  const Word name = read_one_name(reader, node, word, expected);
  if (name.value.empty()) return;
  std::tie(input.name, input.provider) = split_at_dot(name, !node.quoted());
  if (input.provider.value.empty())
    reader.unexpected(node, word, expected,
                      fmt::format("if it has no `providers`, the only one is called `{}.default`", name.value));
}

InputSpec read_input(Reader& reader, const YamlNode& mapping, std::size_t which) {
  using Kind = InputSpec::Kind;
  const std::string& word = input_words()[which];
  const YamlNode& value = *mapping.find(word);
  InputSpec input;
  input.span = mapping.span;
  input.kind = {static_cast<Kind>(which), Reader::key_of(mapping, word).span};
  input.shown = fmt::format("{} {}", word, to_text(data_of(value)));
  switch (input.kind.value) {
  case Kind::request: input.requests = read_root_requests(reader, value); break;
  case Kind::cancel: input.name = read_one_name(reader, value, word, "a root"); break;
  case Kind::trigger: input.name = read_one_name(reader, value, word, "the name of a trigger"); break;
  case Kind::set: input.set = read_settings(reader, &value, word); break;
  case Kind::enable:
  case Kind::disable: read_provider_name(reader, value, input, word); break;
  }
  return input;
}

std::vector<InputSpec> read_inputs(Reader& reader, const YamlNode* node) {
  std::vector<InputSpec> out;
  if (!reader.is_list(node, "inputs", "a list of inputs")) return out;
  for (const YamlNode& item : node->items) {
    if (!reader.is_mapping(&item, "inputs", "a mapping such as {request: Walk}", "", "")) continue;
    reader.know_keys(item, "an input", input_words(), slips_of_input());
    if (const auto word = only_word(reader, item, "an input", input_words(), input_words()))
      out.push_back(read_input(reader, item, *word));
  }
  return out;
}

std::optional<ExpectSpec> read_expect(Reader& reader, const YamlNode* node) {
  constexpr std::string_view expected = "a text with one event a line";
  if (node && node->kind == YamlNode::Kind::list)
    reader.unexpected(*node, "expect", expected, "write `expect: |`, and below it each event in a line without a dash");
  if ((node && node->kind == YamlNode::Kind::list) || !reader.is_scalar(node, "expect", expected)) return std::nullopt;
  ExpectSpec out{lines_of(*node, reader.source()), node->span};
  std::erase_if(out.lines, [](const Word& line) { return line.value.empty() || line.value.starts_with('#'); });
  return out;
}

StepSpec read_step(Reader& reader, const YamlNode& mapping) {
  static const Keys words = with(input_words(), {"advance", "inputs"});
  static const Keys keys = with(words, {"expect", "doc"});
  StepSpec step;
  step.span = mapping.span;
  reader.know_keys(mapping, "a step", keys, slips_of_step());
  if (const auto word = only_word(reader, mapping, "a step", words, keys)) {
    if (words[*word] == "advance")
      step.advance = reader.duration(mapping.find("advance"), "advance", 0);
    else if (words[*word] == "inputs")
      step.inputs = read_inputs(reader, mapping.find("inputs"));
    else
      step.inputs = {read_input(reader, mapping, *word)};
  }
  step.expect = read_expect(reader, mapping.find("expect"));
  step.doc = reader.text(mapping.find("doc"), "doc");
  return step;
}

void read_top(Reader& reader, const YamlNode& root, const std::string& path, FileAccess& files, ScenarioSpec& out) {
  static const Keys keys{"scenario", "behaviour", "given", "script", "steps", "doc"};
  const Span first = root.pairs.empty() ? root.span : root.pairs.front().key.span;
  out.behaviour = {"", first};
  if (reader.is_another_file(root, "a scenario file", "steps", {"language", "groups"}, slips_of_scenario_file()))
    return;
  reader.know_keys(root, "a scenario file", keys, slips_of_scenario_file());
  out.title = reader.text(root.find("scenario"), "scenario");
  out.behaviour = reader
                      .word(reader.require(root, "behaviour", "a scenario file", first, "behaviour: walker.yaml"),
                            "behaviour", "the path of a behaviour file")
                      .value_or(out.behaviour);
  if (!out.behaviour.value.empty()) out.behaviour_path = files.beside(path, out.behaviour.value);
  out.doc = reader.text(root.find("doc"), "doc");
  out.given = read_settings(reader, root.find("given"), "given");
  const YamlNode* script = root.find("script");
  if (reader.is_mapping(script, "script"))
    for (const YamlPair& pair : script->pairs) out.script.push_back(read_script_entry(reader, pair));
  const YamlNode* steps = root.find("steps");
  if (!reader.is_list(steps, "steps", "a list of steps", "write `- ` before each step: `- request: Walk`")) return;
  const auto help = [](const YamlNode& item) {
    const bool is_name =
        item.kind == YamlNode::Kind::scalar && std::all_of(item.text.begin(), item.text.end(), is_word);
    return is_name && !item.text.empty() ? fmt::format("to request it, write `request: {}`", item.text) : "";
  };
  for (const YamlNode& item : steps->items)
    if (reader.is_mapping(&item, "steps", "a mapping such as {request: Walk}", help(item), ""))
      out.steps.push_back(read_step(reader, item));
}

} // namespace

ReadScenarioResult read_scenario(const std::string& path, FileAccess& files, Sources& sources) {
  ReadScenarioResult result;
  const LoadedFile loaded = load_file(path, files, sources, result.diagnostics);
  result.readable = loaded.readable;
  result.scenario.file = loaded.id;
  if (!loaded.readable) return result;
  const std::string& text = sources[loaded.id].text();
  result.scenario.span = {loaded.id, 0, static_cast<std::uint32_t>(text.size())};
  const YamlNode root = read_yaml(loaded.id, text, result.diagnostics);
  Reader reader(text, result.diagnostics);
  if (root.kind == YamlNode::Kind::mapping)
    read_top(reader, root, path, files, result.scenario);
  else if (root.kind != YamlNode::Kind::broken)
    reader.error("wrong_node_kind", root.span, fmt::format("a scenario file is a mapping, found {}", found(root)),
                 "it begins with `behaviour: file.yaml`");
  sort_by_place(result.diagnostics);
  return result;
}

} // namespace director::dsl
