// Header: dsl/reading/read_state.hpp. Test: tests/dsl/reading/read_state_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/reading/read_state.hpp"

#include "dsl/reading/read_tasks.hpp"

#include <fmt/format.h>

#include <utility>

namespace director::dsl {

namespace {

std::optional<RangeSpec> read_range(Reader& reader, const YamlNode* node) {
  constexpr std::string_view expected = "a list of the lowest and the highest number";
  constexpr const char* help = "for example `[0, 100]`";
  if (!reader.is_list(node, "range", expected, help, help)) return std::nullopt;
  if (node->items.size() != 2) {
    reader.error("wrong_node_kind", node->span,
                 fmt::format("`range`: expected {}, found a list of {}", expected, node->items.size()), help);
    return std::nullopt;
  }
  const auto low = reader.number(&node->items[0], "range"), high = reader.number(&node->items[1], "range");
  if (!low || !high) return std::nullopt;
  if (low->value > high->value) {
    reader.error("wrong_node_kind", node->span,
                 fmt::format("`range`: expected the lower number first, found {} above {}", low->value, high->value),
                 fmt::format("write `[{}, {}]`", high->value, low->value));
    return std::nullopt;
  }
  return RangeSpec{*low, *high, node->span};
}

/// `expires: 500 ms`, `expires: {after: 2 s, to: lost}`.
std::optional<ExpiresSpec> read_expires(Reader& reader, const YamlNode* node, const Word& key) {
  static const Keys keys{"after", "to"};
  if (!node) return std::nullopt;
  if (node->kind != YamlNode::Kind::mapping) {
    const auto after = reader.duration(node, "expires");
    return after ? std::optional(ExpiresSpec{*after, {}}) : std::nullopt;
  }
  reader.know_keys(*node, "`expires`", keys);
  const auto after = reader.duration(reader.require(*node, "after", "`expires`", key.span, "after: 500 ms"), "after");
  auto to = reader.word(node->find("to"), "to", "a value of the state");
  return after ? std::optional(ExpiresSpec{*after, std::move(to)}) : std::nullopt;
}

/// For `Motion: [still, moving]` and `Door: bool`.
std::string help_for_short_state(const YamlPair& pair) {
  if (pair.value.kind == YamlNode::Kind::list)
    return fmt::format("its values stand in `values`: `{}: {{values: [...]}}`", pair.key.value);
  const bool builtin = pair.value.kind == YamlNode::Kind::scalar && help_for_type(pair.value.text);
  return builtin ? *help_for_type(pair.value.text) : "";
}

/// A `value` beside the possible values, or that is one, is the one at the start; otherwise `values` is meant.
const Slips& slips_with_value() {
  static const Slips slips = [] {
    Slips out = slips_of_state();
    out.push_back({{"value"}, "the value at the start stands in `initial`"});
    return out;
  }();
  return slips;
}

/// A type of C++ itself is not accepted as the name of an enum, so that its enumerators are not searched.
std::optional<Word> read_type(Reader& reader, const YamlNode& mapping) {
  constexpr std::string_view expected = "a C++ enum";
  const YamlNode* node = mapping.find("type");
  const bool scalar = node != nullptr && node->kind == YamlNode::Kind::scalar;
  const std::string* help = scalar ? help_for_type(node->text) : nullptr;
  if (help == nullptr) return reader.cpp_word(node, "type", expected, "bad_type", enum_fault);
  const bool has_values = mapping.find("values") || mapping.find("range");
  reader.unexpected(*node, "type", expected,
                    has_values ? "leave it out: what the state can be is said beside it" : *help);
  return std::nullopt;
}

} // namespace

StateSpec read_state(Reader& reader, const YamlPair& pair) {
  static const Keys keys{"type",    "values", "unordered", "range", "initial", "external",
                         "expires", "of",     "doc",       "allow", "because"};
  StateSpec state;
  state.span = pair.span;
  state.name = reader.name(pair);
  state.external.span = pair.key.span;
  const YamlNode& mapping = pair.value;
  if (!reader.is_mapping(&mapping, pair.key.value, "a mapping", help_for_short_state(pair),
                         "for example `{values: [low, high]}`, or `{range: [0, 100]}`"))
    return state;
  const std::string thing = fmt::format("state `{}`", pair.key.value);
  const YamlNode* value = mapping.find("value");
  const bool is_initial = mapping.find("values") || mapping.find("range") || mapping.find("type") ||
                          (value && value->kind == YamlNode::Kind::scalar);
  reader.know_keys(mapping, thing, keys, is_initial ? slips_with_value() : slips_of_state());
  reader.exclude(mapping, "range", "values", "leave out one: `range` is for whole numbers, `values` is for words");
  const YamlNode* type = mapping.find("type");
  if (!type || !help_for_type(type->text)) // its message is about `type` alone
    reader.exclude(mapping, "range", "type", "leave out one: `range` is for whole numbers, `type` for an enum of C++");
  if (!mapping.find("values") && !type) // else leaving out the range corrects both
    reader.exclude(mapping, "range", "unordered",
                   "leave out `unordered`: the numbers of a `range` all have their place");
  reader.exclude(mapping, "of", "external", "leave out `of` if the outside may set it, else `external`");
  if (reader.lacks(mapping, "values") && reader.lacks(mapping, "range") && reader.lacks(mapping, "type"))
    reader.error("missing_key", pair.key.span, thing + " needs `values`, `range` or `type`",
                 "for example `values: [low, high]`, or `range: [0, 100]`");
  if (mapping.find("of") && reader.lacks(mapping, "initial"))
    reader.error("missing_key", pair.key.span, thing + " belongs to a group and needs `initial`",
                 "give it the value to which it returns when the group stops");
  state.type = read_type(reader, mapping);
  if (const YamlNode* values = mapping.find("values")) {
    constexpr const char* help = "for example `[low, high]`";
    state.values = reader.words(values, "values", "the name of a value", help);
    if (values->kind == YamlNode::Kind::list && values->items.empty())
      reader.error("wrong_node_kind", values->span, "`values`: expected at least one value, found an empty list", help);
  }
  state.unordered = reader.words(mapping.find("unordered"), "unordered", "the name of a value");
  state.range = read_range(reader, mapping.find("range"));
  state.initial = reader.word(mapping.find("initial"), "initial", "a value of the state");
  if (const auto flag = reader.flag(mapping.find("external"), "external")) state.external = *flag;
  if (const YamlNode* expires = mapping.find("expires"))
    state.expires = read_expires(reader, expires, Reader::key_of(mapping, "expires"));
  state.of = reader.word(mapping.find("of"), "of", "the name of a group");
  state.doc = reader.text(mapping.find("doc"), "doc");
  state.allow = read_allow(reader, mapping);
  return state;
}

} // namespace director::dsl
