// Header: compiler/base/html.hpp. Test: tests/compiler/base/html_test.cpp,
// tests/compiler/emit/graph/svg_test.cpp. SPDX-License-Identifier: MIT
#include "compiler/base/html.hpp"

#include "dsl/lexical/characters.hpp"

namespace director::compiler {

std::string without_controls(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto letter = static_cast<unsigned char>(text[i]);
    const std::size_t length = dsl::utf8_length(text, i);
    if (length == 0) { // possible in a path
      out += "\uFFFD";
      continue;
    }
    const bool is_no_character =
        text.substr(i).starts_with("\xEF\xBF\xBE") || text.substr(i).starts_with("\xEF\xBF\xBF");
    const bool is_control = letter < 0x20 && letter != '\t' && letter != '\n' && letter != '\r';
    if (is_no_character || is_control) {
      out += ' ';
    } else {
      out += text.substr(i, length);
    }
    i += length - 1;
  }
  return out;
}

std::string html(std::string_view text) {
  std::string out;
  for (const char letter : without_controls(text)) {
    switch (letter) {
    case '&': out += "&amp;"; break;
    case '<': out += "&lt;"; break;
    case '>': out += "&gt;"; break;
    case '"': out += "&quot;"; break;
    default: out += letter;
    }
  }
  return out;
}

std::string html_attribute(std::string_view text) {
  std::string out;
  for (const char letter : html(text)) {
    if (letter == '\n') out += "&#10;";
    if (letter != '\n') out += letter;
  }
  return out;
}

} // namespace director::compiler
