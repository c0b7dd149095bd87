// Header: dsl/reading/reader.hpp. Test: tests/dsl/reading/reader_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/reading/reader.hpp"

#include "dsl/lexical/beyond_ascii.hpp"
#include "dsl/lexical/characters.hpp"
#include "dsl/lexical/names.hpp"
#include "dsl/lexical/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace director::dsl {

namespace {

constexpr std::size_t longest_quote = 40;
constexpr std::size_t most_quoted_words = 4;

std::string in_quotes(std::string_view text) {
  const std::size_t line = text.find('\n');
  if (line == std::string_view::npos && text.size() <= longest_quote) return fmt::format("`{}`", text);
  std::size_t size = std::min(line, longest_quote);
  while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U) --size; // not within a character
  return fmt::format("`{}…`", text.substr(0, size));
}

/// The parts of both `open|shut` and `open, shut`.
std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(",|"), text.size());
    std::string_view part = text.substr(0, end);
    part.remove_prefix(std::min(part.find_first_not_of(' '), part.size()));
    part = part.substr(0, part.find_last_not_of(' ') + 1);
    if (!part.empty()) out.push_back(part);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

/// Whether this is the entry of a list without the blank behind its dash: `-Walk`, `-name: walking`.
std::optional<std::string_view> behind_bare_dash(const YamlNode& node) {
  const bool mapping = node.kind == YamlNode::Kind::mapping && !node.pairs.empty();
  if (!mapping && (node.kind != YamlNode::Kind::scalar || node.quoted())) return std::nullopt;
  const std::string_view text = mapping ? node.pairs.front().key.value : node.text;
  if (text.size() < 2 || text[0] != '-' || !(is_letter(text[1]) || text[1] == '_')) return std::nullopt;
  return text.substr(1, text.find(' ') - 1);
}

} // namespace

std::string found(const YamlNode& node) {
  switch (node.kind) {
  case YamlNode::Kind::broken: return "nothing";
  case YamlNode::Kind::null:
    return node.text.empty() ? "nothing" : fmt::format("`{}`, which YAML reads as nothing", node.text);
  case YamlNode::Kind::list: return "a list";
  case YamlNode::Kind::mapping: return "a mapping";
  case YamlNode::Kind::scalar: break;
  }
  return (node.quoted() ? "the text " : "") + in_quotes(node.text);
}

bool is_a_no(std::string_view text) {
  constexpr std::array<std::string_view, 12> spellings{"no",  "No",  "NO",    "n",     "N",     "off",
                                                       "Off", "OFF", "false", "False", "FALSE", "0"};
  return std::find(spellings.begin(), spellings.end(), text) != spellings.end();
}

std::optional<std::int64_t> parse_number(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc() || end != text.data() + text.size()) return std::nullopt;
  const std::string_view digits = text.starts_with('-') ? text.substr(1) : text;
  if (digits.starts_with('0') && text != "0") return std::nullopt; // octal in some tools
  return value;
}

std::optional<OddNumber> odd_number(std::string_view text) {
  const auto write = [](std::optional<std::int64_t> value, std::string_view why) -> std::optional<OddNumber> {
    if (!value) return std::nullopt;
    return OddNumber{*value, fmt::format("write `{}`{}", *value, why)};
  };
  if (text.starts_with("0x") || text.starts_with("0X")) {
    std::int64_t value = 0;
    const std::string_view digits = text.substr(2);
    const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    if (failed != std::errc() || end != digits.data() + digits.size() || value < 0) return std::nullopt;
    return write(value, ": a number is decimal");
  }
  if (text.starts_with('+')) return write(parse_number(text.substr(1)), ", without the plus");
  const std::string sign = text.starts_with('-') ? "-" : "";
  std::string_view digits = text.substr(sign.size());
  if (!digits.starts_with('0') || parse_number(text)) return std::nullopt;
  const bool one_zero = digits == "0";
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return write(digits.empty() ? 0 : parse_number(sign + std::string(digits)),
               one_zero ? "" : ", without leading zeros: older YAML tools read those as octal");
}

void Reader::error(std::string id, Span span, std::string message, std::string help, std::vector<Note> notes) {
  diagnostics_.push_back({std::move(id), Level::error, span, std::move(message), std::move(notes), std::move(help)});
}

void Reader::unexpected(const YamlNode& node, std::string_view subject, std::string_view expected, std::string help) {
  if (node.kind == YamlNode::Kind::broken) return;
  const bool is_plain = node.kind == YamlNode::Kind::scalar && !node.quoted();
  if (std::string odd = is_plain ? help_for_look_alike(node.text) : ""; !odd.empty()) help = std::move(odd);
  error("wrong_node_kind", node.span, fmt::format("`{}`: expected {}, found {}", subject, expected, found(node)),
        std::move(help));
}

bool Reader::is_mapping(const YamlNode* node, std::string_view subject, std::string_view expected, std::string help,
                        std::string for_nothing) {
  if (!node) return false;
  const bool good = node->kind == YamlNode::Kind::mapping;
  if (node->kind == YamlNode::Kind::null) help = std::move(for_nothing);
  const std::size_t blank = node->text.find(' ');
  if (help.empty() && node->kind == YamlNode::Kind::scalar && !node->quoted() && blank != std::string::npos)
    help = fmt::format("if `{0}` is a key, write `{0}:`", node->text.substr(0, blank));
  if (!good) unexpected(*node, subject, expected, std::move(help));
  return good;
}

bool Reader::is_list(const YamlNode* node, std::string_view subject, std::string_view expected, std::string help,
                     std::string for_nothing) {
  if (!node) return false;
  const bool good = node->kind == YamlNode::Kind::list;
  if (node->kind == YamlNode::Kind::null) help = std::move(for_nothing);
  if (const auto entry = behind_bare_dash(*node))
    help = fmt::format("an entry of a list needs a blank behind its dash: `- {}`", *entry);
  if (help.empty() && node->kind == YamlNode::Kind::scalar && !node->text.empty())
    help = fmt::format("write `[{}]`", node->text);
  if (!good) unexpected(*node, subject, expected, std::move(help));
  return good;
}

bool Reader::is_scalar(const YamlNode* node, std::string_view subject, std::string_view expected) {
  if (!node) return false;
  const bool good = node->kind == YamlNode::Kind::scalar;
  if (!good) unexpected(*node, subject, expected);
  return good;
}

void Reader::know_keys(const YamlNode& mapping, std::string_view thing, const Keys& keys, const Slips& slips) {
  for (const YamlPair& pair : mapping.pairs) {
    const std::string& key = pair.key.value;
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    const std::string message = fmt::format("{} has no key {}", thing, in_quotes(key));
    if (const std::string* help = help_for(slips, key)) {
      error("unknown_key", pair.key.span, message, *help);
      continue;
    }
    if (std::string odd = help_for_look_alike(key); !odd.empty()) {
      error("unknown_key", pair.key.span, message, std::move(odd));
      continue;
    }
    if (const std::string odd = first_beyond_ascii(key); !odd.empty()) {
      error("unknown_key", pair.key.span, message, fmt::format("it has {} in it, which no key has", odd));
      continue;
    }
    const auto near = suggest(key, keys);
    if (near) misspelt_.emplace_back(&mapping, *near);
    error("unknown_key", pair.key.span, message,
          near ? fmt::format("did you mean `{}`?", *near) : fmt::format("it may have {}", fmt::join(keys, ", ")));
  }
}

bool Reader::is_another_file(const YamlNode& file, std::string_view thing, std::string_view own, const Keys& foreign,
                             const Slips& slips) {
  const auto key = std::find_if(foreign.begin(), foreign.end(), [&](const auto& each) { return file.find(each); });
  if (file.find(own) || key == foreign.end()) return false;
  error("unknown_key", key_of(file, *key).span, fmt::format("{} has no key {}", thing, in_quotes(*key)),
        *help_for(slips, *key));
  return true;
}

void Reader::exclude(const YamlNode& mapping, std::string_view key, std::string_view other, std::string_view help) {
  if (!mapping.find(key) || !mapping.find(other)) return;
  Word first = key_of(mapping, key), second = key_of(mapping, other);
  if (second.span < first.span) std::swap(first, second);
  error("exclusive_keys", second.span, fmt::format("`{}` and `{}` exclude each other", first.value, second.value),
        std::string(help), {{first.span, fmt::format("`{}` stands here", first.value)}});
}

const Word& Reader::key_of(const YamlNode& mapping, std::string_view key) {
  return std::find_if(mapping.pairs.begin(), mapping.pairs.end(),
                      [&](const YamlPair& pair) { return pair.key.value == key; })
      ->key;
}

bool Reader::lacks(const YamlNode& mapping, std::string_view key) const {
  const auto meant = [&](const auto& entry) { return entry.first == &mapping && entry.second == key; };
  return !mapping.left_out && !mapping.find(key) && std::none_of(misspelt_.begin(), misspelt_.end(), meant);
}

const YamlNode* Reader::require(const YamlNode& mapping, std::string_view key, std::string_view thing, Span place,
                                std::string_view example) {
  const YamlNode* node = mapping.find(key);
  if (lacks(mapping, key))
    error("missing_key", place, fmt::format("{} needs `{}`", thing, key), fmt::format("for example `{}`", example));
  return node;
}

void Reader::warn_of_trap(const Word& word, bool quoted) {
  const bool old = is_old_boolean(word.value);
  if (quoted || !(old || is_other_boolean(word.value))) return;
  diagnostics_.push_back(
      {"yaml_word_trap",
       Level::warning,
       word.span,
       fmt::format("{} YAML tools read a bare `{}` as a boolean", old ? "older" : "other", word.value),
       {},
       fmt::format("write \"{}\", or choose another word", word.value)});
}

std::optional<Word> Reader::word(const YamlNode* node, std::string_view subject, std::string_view expected) {
  if (!is_scalar(node, subject, expected)) return std::nullopt;
  if (node->text.empty()) {
    unexpected(*node, subject, expected);
    return std::nullopt;
  }
  Word word{node->text, node->span};
  warn_of_trap(word, node->quoted());
  return word;
}

std::vector<Word> Reader::words(const YamlNode* node, std::string_view subject, std::string_view expected,
                                std::string for_nothing) {
  std::vector<Word> out;
  std::vector<std::string_view> keys; // of a mapping that stands there instead
  if (node)
    for (const YamlPair& pair : node->pairs) keys.push_back(pair.key.value);
  // Also for a list in the spelling of another tool, `open|shut`.
  if (node && node->kind == YamlNode::Kind::scalar) keys = parts_of(node->text);
  const bool named = !keys.empty() && keys.size() <= most_quoted_words;
  if (!is_list(node, subject, "a list", named ? fmt::format("write `[{}]`", fmt::join(keys, ", ")) : "",
               std::move(for_nothing)))
    return out;
  for (const YamlNode& item : node->items)
    if (auto one = word(&item, subject, expected)) out.push_back(std::move(*one));
  return out;
}

std::optional<Word> Reader::cpp_word(const YamlNode* node, std::string_view subject, std::string_view expected,
                                     std::string_view id, std::optional<CppFault> (*fault)(std::string_view)) {
  auto out = word(node, subject, expected);
  if (!out) return out;
  if (auto found = fault(out->value)) {
    error(std::string(id), out->span, std::move(found->message), std::move(found->help));
    return std::nullopt;
  }
  return out;
}

Word Reader::name(const YamlPair& pair) {
  if (pair.key.value.empty())
    error("wrong_node_kind", pair.key.span, "a name is a word, found the text ``", "give it a name");
  warn_of_trap(pair.key, pair.key_style != YamlNode::Style::plain);
  return pair.key;
}

std::optional<Word> Reader::text(const YamlNode* node, std::string_view subject) {
  if (!is_scalar(node, subject, "a text")) return std::nullopt;
  return Word{node->text, node->span};
}

std::optional<Located<bool>> Reader::flag(const YamlNode* node, std::string_view subject, std::string_view expected) {
  if (!is_scalar(node, subject, expected)) return std::nullopt;
  if (!node->quoted() && (node->text == "true" || node->text == "false"))
    return Located<bool>{node->text == "true", node->span};
  const std::string_view text = node->text;
  const bool yes = text == "yes" || text == "on" || text == "True" || text == "TRUE" || text == "true" || text == "1";
  unexpected(*node, subject, expected,
             yes             ? "write `true`, without quotes"
             : is_a_no(text) ? "write `false`, without quotes"
                             : "");
  return std::nullopt;
}

/// Whether the number is outside of 64 bits.
static bool is_huge(std::string_view text) {
  std::string_view digits = text;
  if (digits.starts_with('-')) digits.remove_prefix(1);
  return digits.size() > 1 && !digits.starts_with('0') && all_among(digits, "0123456789") && !parse_number(text);
}

std::optional<Located<std::int64_t>> Reader::number(const YamlNode* node, std::string_view subject, Bounds bounds) {
  if (!is_scalar(node, subject, "a whole number")) return std::nullopt;
  const auto value = node->quoted() ? std::nullopt : parse_number(node->text);
  if (value && *value >= bounds.low && *value <= bounds.high) return Located<std::int64_t>{*value, node->span};
  const Bounds all;
  std::string range;
  if (bounds.high != all.high || is_huge(node->text))
    range = fmt::format(" from {} to {}", bounds.low, bounds.high);
  else if (bounds.low != all.low)
    range = fmt::format(" from {}", bounds.low);
  const bool is_number = node->quoted() && parse_number(node->text);
  const auto odd = odd_number(node->text);
  const bool fits = odd && odd->value >= bounds.low && odd->value <= bounds.high;
  unexpected(*node, subject, "a whole number" + range, is_number ? "write it without quotes" : fits ? odd->help : "");
  return std::nullopt;
}

std::optional<Located<Duration>> Reader::duration(const YamlNode* node, std::string_view subject, std::int64_t least) {
  constexpr std::string_view expected = "a duration such as 10 ms";
  constexpr const char* help = "a whole number and one of us, ms, s, min";
  if (node && node->kind == YamlNode::Kind::list) {
    unexpected(*node, subject, expected, help);
    return std::nullopt;
  }
  if (!is_scalar(node, subject, expected)) return std::nullopt;
  const auto value = parse_duration(node->text);
  if (value && value->microseconds() >= least) return Located<Duration>{*value, node->span};
  if (const auto most = most_instead_of(node->text))
    unexpected(*node, subject, fmt::format("a duration of at most {}", to_text(*most)), "");
  else
    unexpected(*node, subject, value ? "a duration above 0" : expected, value ? "" : help);
  return std::nullopt;
}

} // namespace director::dsl
