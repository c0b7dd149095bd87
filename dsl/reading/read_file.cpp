// Header: dsl/reading/read_file.hpp. Test: tests/dsl/reading/read_file_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/reading/read_file.hpp"

#include "dsl/reading/read_group.hpp"
#include "dsl/reading/read_state.hpp"
#include "dsl/reading/read_tasks.hpp"

#include <fmt/format.h>

#include <utility>

namespace director::dsl {

namespace {

constexpr std::int64_t known_language = 1;

/// Whether the file is in this language, so that the rest can be read.
bool read_language(Reader& reader, const YamlNode& root) {
  const auto version = reader.number(root.find("language"), "language");
  if (!version || version->value == known_language) return true;
  reader.error("language_version", version->span,
               fmt::format("this compiler reads language {}, found {}", known_language, version->value),
               version->value > known_language ? "use the compiler that the file was written for"
                                               : fmt::format("write `language: {}`", known_language));
  return false;
}

CppSpec read_cpp(Reader& reader, const YamlNode* node) {
  static const Keys keys{"namespace", "headers"};
  CppSpec cpp;
  if (!reader.is_mapping(node, "cpp", "a mapping", "headers are a list: `cpp: {headers: [robot/messages.hpp]}`"))
    return cpp;
  reader.know_keys(*node, "`cpp`", keys, slips_of_cpp());
  cpp.name_space = reader.word(node->find("namespace"), "namespace", "a C++ namespace");
  const YamlNode* headers = node->find("headers");
  if (!reader.is_list(headers, "headers")) return cpp;
  for (const YamlNode& item : headers->items) {
    if (auto header = reader.cpp_word(&item, "headers", "the path of a header", "bad_header", header_fault))
      cpp.headers.push_back(std::move(*header));
  }
  return cpp;
}

LimitsSpec read_limits(Reader& reader, const YamlNode* node) {
  static const Keys keys{"trials", "pass"};
  LimitsSpec limits;
  if (!reader.is_mapping(node, "limits")) return limits;
  reader.know_keys(*node, "`limits`", keys);
  limits.trials = reader.number(node->find("trials"), "trials", {1});
  limits.pass = reader.number(node->find("pass"), "pass", {1});
  return limits;
}

/// `beats: {FallRecovery: Striker}`.
std::vector<Word> read_pair(Reader& reader, const YamlNode& node) {
  if (!reader.is_mapping(&node, "beats", "a mapping such as {Winner: Loser}", "", "")) return {};
  if (node.pairs.size() != 1) {
    reader.error("wrong_node_kind", node.span,
                 fmt::format("`beats`: expected one pair {{Winner: Loser}}, found {}", node.pairs.size()),
                 "write an assertion for each pair");
    return {};
  }
  auto loser = reader.word(&node.pairs[0].value, node.pairs[0].key.value, "the name of a group");
  return loser ? std::vector<Word>{reader.name(node.pairs[0]), std::move(*loser)} : std::vector<Word>{};
}

/// `soft: {from: Walk, to: Kick}`.
std::vector<Word> read_from_to(Reader& reader, const YamlNode& node, Span key) {
  static const Keys keys{"from", "to"};
  std::vector<Word> groups;
  if (!reader.is_mapping(&node, "soft", "a mapping {from: A, to: B}", "", "")) return groups;
  reader.know_keys(node, "`soft`", keys);
  for (const std::string& end : keys)
    if (auto group = reader.word(reader.require(node, end, "`soft`", key, "soft: {from: Walk, to: Kick}"), end,
                                 "the name of a group"))
      groups.push_back(std::move(*group));
  return groups.size() == keys.size() ? groups : std::vector<Word>{};
}

std::vector<Word> read_together(Reader& reader, const YamlNode& node) {
  constexpr const char* help = "for example `never_together: [Walk, GetUp]`";
  std::vector<Word> groups = reader.words(&node, "never_together", "the name of a group", help);
  if (node.kind == YamlNode::Kind::list && node.items.size() < 2) {
    reader.error("wrong_node_kind", node.span,
                 fmt::format("`never_together`: expected two groups or more, found {}", node.items.size()), help);
    return {};
  }
  return groups;
}

std::optional<AssertionSpec> read_assertion(Reader& reader, const YamlNode& node) {
  using Kind = AssertionSpec::Kind;
  static const Keys kinds{"never_together", "beats", "can_run", "soft"}; // in the order of Kind
  if (!reader.is_mapping(&node, "assertions", "a mapping such as {can_run: Kick}", "", "")) return std::nullopt;
  reader.know_keys(node, "an assertion", kinds, slips_of_assertion());
  for (std::size_t i = 0; i < kinds.size(); ++i)
    for (std::size_t j = i + 1; j < kinds.size(); ++j)
      reader.exclude(node, kinds[i], kinds[j], "write each as an entry of its own, with a `-`");
  if (node.pairs.empty())
    reader.error("wrong_node_kind", node.span,
                 "`assertions`: expected one of never_together, beats, can_run, soft, found none",
                 "for example `- can_run: Kick`");
  AssertionSpec out;
  out.span = node.span;
  for (std::size_t i = 0; i < kinds.size() && out.groups.empty(); ++i) {
    const YamlNode* value = node.find(kinds[i]);
    if (!value) continue;
    const Span key = Reader::key_of(node, kinds[i]).span;
    out.kind = {static_cast<Kind>(i), key};
    switch (out.kind.value) {
    case Kind::never_together: out.groups = read_together(reader, *value); break;
    case Kind::beats: out.groups = read_pair(reader, *value); break;
    case Kind::can_run:
      if (auto group = reader.word(value, "can_run", "the name of a group")) out.groups = {std::move(*group)};
      break;
    case Kind::soft: out.groups = read_from_to(reader, *value, key); break;
    }
  }
  return out.groups.empty() ? std::nullopt : std::optional(std::move(out));
}

/// Each pair of a mapping, read by `read`. `example`: a pair.
template <class Read>
auto read_named(Reader& reader, const YamlNode* node, std::string_view subject, std::string_view example, Read read) {
  std::vector<decltype(read(reader, node->pairs.front()))> out;
  std::string help;
  if (node && node->kind == YamlNode::Kind::list)
    help = fmt::format("each with its name and a `:`, such as `{}`", example);
  if (!reader.is_mapping(node, subject, "a mapping", std::move(help))) return out;
  for (const YamlPair& pair : node->pairs) out.push_back(read(reader, pair));
  return out;
}

} // namespace

BehaviourSpec read_file(Reader& reader, const YamlNode& root) {
  static const Keys keys{"behaviour", "language", "imports", "cpp",        "layers", "states", "triggers", "extern",
                         "roots",     "groups",   "extend",  "assertions", "limits", "doc",    "allow",    "because"};
  BehaviourSpec file;
  file.file = root.span.file;
  file.span = {root.span.file, 0, static_cast<std::uint32_t>(reader.source().size())};
  if (reader.is_another_file(root, "a behaviour file", "language", {"scenario", "steps"}, slips_of_file())) return file;
  if (!read_language(reader, root)) return file;
  const Span first = root.pairs.empty() ? root.span : root.pairs.front().key.span;
  reader.know_keys(root, "a behaviour file", keys, slips_of_file());
  reader.require(root, "language", "a behaviour file", first, fmt::format("language: {}", known_language));
  file.name = reader
                  .word(reader.require(root, "behaviour", "a behaviour file", first, "behaviour: soccer"), "behaviour",
                        "a name")
                  .value_or(Word{"", first});
  file.doc = reader.text(root.find("doc"), "doc");
  for (Word& path : reader.words(root.find("imports"), "imports", "the path of a behaviour file"))
    file.imports.push_back({std::move(path), {}});
  file.cpp = read_cpp(reader, root.find("cpp"));
  file.layers = reader.words(root.find("layers"), "layers", "the name of a layer");
  file.states = read_named(reader, root.find("states"), "states", "Motion: {values: [still, moving]}", read_state);
  file.triggers = reader.words(root.find("triggers"), "triggers", "the name of a trigger");
  file.externs = reader.words(root.find("extern"), "extern", "the name of a group");
  file.roots = read_tasks(reader, root.find("roots"), "roots");
  file.groups = read_named(reader, root.find("groups"), "groups", "Legs: {}", read_group);
  file.extend = read_named(reader, root.find("extend"), "extend", "Walk: {providers: [{name: fast}]}", read_extend);
  const YamlNode* assertions = root.find("assertions");
  if (reader.is_list(assertions, "assertions", "a list", "write `- ` before each of them"))
    for (const YamlNode& item : assertions->items)
      if (auto assertion = read_assertion(reader, item)) file.assertions.push_back(std::move(*assertion));
  file.limits = read_limits(reader, root.find("limits"));
  file.allow = read_allow(reader, root);
  return file;
}

} // namespace director::dsl
