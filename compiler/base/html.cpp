// Header: compiler/base/html.hpp. Test: tests/compiler/page/pages_test.cpp, tests/compiler/cli/picture_svg_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/base/html.hpp"

namespace director::compiler {

std::string html(std::string_view text) {
  std::string out;
  for (const char letter : text) {
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
