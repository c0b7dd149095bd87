// Door: dsl/read_state.hpp. Test: tests/dsl/read_state_test.cpp.
#include "dsl/read_state.hpp"

#include "dsl/read_tasks.hpp"

#include <fmt/format.h>

#include <utility>

namespace director::dsl {

namespace {

std::optional<RangeSpec> read_range(Reader& reader, const YamlNode* node) {
  constexpr std::string_view expected = "a list of the lowest and the highest number";
  if (!reader.is_list(node, "range", expected)) return std::nullopt;
  if (node->items.size() != 2) {
    reader.unexpected(*node, "range", expected, "for example `[0, 100]`");
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

} // namespace

StateSpec read_state(Reader& reader, const YamlPair& pair) {
  static const Keys keys{"type",    "values", "unordered", "range", "initial", "external",
                         "expires", "of",     "doc",       "allow", "because"};
  StateSpec state;
  state.span = pair.span;
  state.name = reader.name(pair);
  state.external.span = pair.key.span;
  const YamlNode& mapping = pair.value;
  if (!reader.is_mapping(&mapping, pair.key.value)) return state;
  const std::string thing = fmt::format("state `{}`", pair.key.value);
  reader.know_keys(mapping, thing, keys);
  reader.exclude(mapping, "range", "values", "leave out one: `range` is for whole numbers, `values` is for words");
  reader.exclude(mapping, "range", "type", "leave out one: `range` is for whole numbers, `type` for an enum of C++");
  reader.exclude(mapping, "of", "external", "leave out `of` if the outside may set it, else `external`");
  if (reader.lacks(mapping, "values") && reader.lacks(mapping, "range") && reader.lacks(mapping, "type"))
    reader.error("missing_key", pair.key.span, thing + " needs `values`, `range` or `type`",
                 "for example `values: [low, high]`, or `range: [0, 100]`");
  if (mapping.find("of") && reader.lacks(mapping, "initial"))
    reader.error("missing_key", pair.key.span, thing + " belongs to a group and needs `initial`",
                 "give it the value to which it returns when the group stops");
  state.type = reader.word(mapping.find("type"), "type", "a C++ enum");
  if (const YamlNode* values = mapping.find("values")) {
    state.values = reader.words(values, "values", "the name of a value");
    if (values->kind == YamlNode::Kind::list && values->items.empty())
      reader.error("wrong_node_kind", values->span, "`values`: expected at least one value, found an empty list",
                   "for example `[low, high]`");
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
