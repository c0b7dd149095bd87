// Header: compiler/emit/graph/palette.hpp. Test: tests/compiler/emit/graph/svg_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/graph/palette.hpp"

#include "compiler/base/html.hpp"

#include <algorithm>

namespace director::compiler::palette {

std::string wrapped(std::string_view text, std::size_t before, std::string_view line_end) {
  constexpr std::size_t width = 36;
  std::string out, line;
  const auto end_line = [&] {
    if (line.empty()) return;
    out += (out.empty() ? "" : std::string(line_end)) + html_attribute(line);
    line.clear();
  };
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (before + line.size() + end > width && !line.empty()) {
      end_line();
      before = 0;
    }
    line += (line.empty() ? "" : " ") + std::string(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  end_line();
  return out;
}

std::string in_quotes(std::string_view text) {
  std::string out = "\"";
  for (const char letter : without_controls(text)) {
    if (letter == '"' || letter == '\\') out += '\\';
    if (letter == '\n') out += "\\n";
    if (letter != '\n') out += letter;
  }
  return out + "\"";
}

} // namespace director::compiler::palette
