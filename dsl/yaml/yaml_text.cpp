// Header: dsl/yaml/yaml_text.hpp. Test: tests/dsl/yaml/yaml_text_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/yaml/yaml_text.hpp"

#include "dsl/lexical/characters.hpp"
#include "dsl/lexical/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace director::dsl {

namespace {

bool is_null_word(std::string_view text) {
  constexpr std::array<std::string_view, 4> words{"~", "null", "Null", "NULL"};
  return std::find(words.begin(), words.end(), text) != words.end();
}

/// Whether text needs no quotes, for a subset of YAML: names, conditions, paths, types and plain sentences.
bool is_plain(std::string_view text) {
  if (text.empty() || is_null_word(text) || is_old_boolean(text) || is_other_boolean(text)) return false;
  const bool negative = text.size() > 1 && text[0] == '-' && is_alphanumeric(text[1]);
  if (!negative && !is_alphanumeric(text[0]) && text[0] != '_' && text[0] != '/' && text[0] != '.') return false;
  if (text.starts_with("...")) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool inner_colon = text[i] == ':' && i + 1 < text.size() && text[i + 1] != ' ';
    if (!inner_colon && !is_alphanumeric(text[i]) && std::string_view("_ ./-+=!<>|;()'").find(text[i]) == text.npos)
      return false;
  }
  return text.back() != ' ';
}

std::string escaped(char c) {
  switch (c) {
  case '"': return "\\\"";
  case '\\': return "\\\\";
  case '\n': return "\\n";
  case '\t': return "\\t";
  case '\r': return "\\r";
  default: return static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? fmt::format("\\x{:02x}", c) : std::string(1, c);
  }
}

} // namespace

std::string yaml_word(std::string_view text) {
  if (is_plain(text)) return std::string(text);
  std::string out = "\"";
  for (const char c : text) out += escaped(c);
  return out + "\"";
}

std::string yaml_list(const std::vector<std::string>& items) { return fmt::format("[{}]", fmt::join(items, ", ")); }

std::string yaml_mapping(const std::vector<std::string>& pairs) {
  return fmt::format("{{{}}}", fmt::join(pairs, ", "));
}

} // namespace director::dsl
