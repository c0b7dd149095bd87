// Header: compiler/page/markdown_text.hpp. Test: tests/compiler/page/pages_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/page/markdown_text.hpp"

#include "compiler/page/message.hpp"
#include "dsl/lexical/characters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace director::compiler::page {

namespace {

/// `:smile:`
bool begins_emoji(std::string_view text) {
  const std::size_t end = std::min(text.find(':', 1), text.size());
  return end > 1 && end < text.size() &&
         std::all_of(text.begin() + 1, text.begin() + static_cast<std::ptrdiff_t>(end), [](char letter) {
           return dsl::is_alphanumeric(letter) || letter == '_' || letter == '+' || letter == '-';
         });
}

/// Viewers replace emojis and formulas in the source, or in the text of a paragraph: in an element of its own, neither
/// begins one.
std::string in_an_element(std::string_view character) { return fmt::format("<span>{}</span>", character); }

} // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char letter = text[at];
    const char next = at + 1 < text.size() ? text[at + 1] : ' ';
    switch (letter) {
    case '&': out += next == '#' || dsl::is_letter(next) ? "&amp;" : "&"; break;
    case '<': out += "&lt;"; break;
    case '>': out += "&gt;"; break;
    case '|': out += "\\|"; break;
    case '*':
    case '_':
    case '[':
    case ']':
    case '`':
    case '\\':
    case '~':
    case '#': out += std::string("\\") + letter; break;
    case '$': out += in_an_element("&#36;"); break;
    case ':': out += begins_emoji(text.substr(at)) ? in_an_element(":") : ":"; break;
    case '\n': out += ' '; break;
    default: out += letter;
    }
  }
  return out;
}

std::string escaped_line(std::string_view text) {
  std::string out = escaped(text);
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const char mark = digits < text.size() ? text[digits] : ' ';
  if (digits == 0 ? mark == '-' || mark == '+' || mark == '=' : mark == '.' || mark == ')') out.insert(digits, "\\");
  return out;
}

std::string code(std::string_view text) { return fmt::format("`{}`", text); }

std::string message(std::string_view text) {
  return in_pieces(
      text, [](std::string_view piece) { return escaped(piece); }, [](std::string_view piece) { return code(piece); });
}

} // namespace director::compiler::page
