// Header: dsl/data.hpp. Test: tests/dsl/data_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/data.hpp"

#include "dsl/lexical/characters.hpp"
#include "dsl/lexical/numbers.hpp"
#include "dsl/yaml/yaml_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace director::dsl {

namespace {

/// Whether the text without quotes would be read as another text, also within brackets, or as data of another kind.
bool needs_quotes(std::string_view text) {
  const auto has = [&](std::string_view part) { return text.find(part) != std::string_view::npos; };
  if (text != trimmed(text) || text.find_first_of("[]{},") != std::string_view::npos || has(": ") || has(" #"))
    return true;
  if (text.ends_with(':') || text == "-" || text.starts_with("- ") || text.starts_with("? ")) return true;
  if (text.find_first_of("#&*!|>'\"%@`") == 0) return true;
  return text.empty() || text == "true" || text == "false" || text == "null" || text == "~" || integer_of_yaml(text) ||
         real_of_yaml(text);
}

/// Whether a character has to be written as an escape.
bool has_control(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
}

/// In quotes, where one of the text is written twice.
std::string quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? "''" : std::string(1, c);
  return out + "'";
}

} // namespace

bool Data::operator==(const Data& other) const {
  if (kind != other.kind || text != other.text || items.size() != other.items.size()) return false;
  if (kind != Kind::mapping) return items == other.items;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto at = std::find(other.keys.begin(), other.keys.end(), keys[i]);
    if (at == other.keys.end() || items[i] != other.items[static_cast<std::size_t>(at - other.keys.begin())])
      return false;
  }
  return true;
}

std::string to_text(const Data& data) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < data.items.size(); ++i)
    parts.push_back((data.kind == Data::Kind::mapping ? data.keys[i] + ": " : "") + to_text(data.items[i]));
  if (data.kind == Data::Kind::list) return fmt::format("[{}]", fmt::join(parts, ", "));
  if (data.kind == Data::Kind::mapping) return fmt::format("{{{}}}", fmt::join(parts, ", "));
  if (data.kind == Data::Kind::text && has_control(data.text)) return yaml_word(data.text);
  if (data.kind == Data::Kind::text && needs_quotes(data.text)) return quoted(data.text);
  return data.text;
}

} // namespace director::dsl
