#pragma once
// SPDX-License-Identifier: MIT
// Kinds of characters, whatever the locale says: of ASCII, the others are none of them.

#include <string_view>

namespace director::dsl {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
constexpr bool is_alphanumeric(char c) { return is_letter(c) || is_digit(c); }
constexpr bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
constexpr char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
/// What a name has.
constexpr bool is_word(char c) { return is_alphanumeric(c) || c == '_'; }
/// One at least.
constexpr bool all_among(std::string_view text, std::string_view characters) {
  return !text.empty() && text.find_first_not_of(characters) == std::string_view::npos;
}

} // namespace director::dsl
