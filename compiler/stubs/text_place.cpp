// Header: compiler/stubs/text_place.hpp. Test: tests/compiler/stubs/text_place_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/stubs/text_place.hpp"

#include "dsl/lexical/characters.hpp"

#include <algorithm>

namespace director::compiler::stubs {

namespace {

std::size_t line_begin(std::string_view text, std::size_t offset) {
  const std::size_t before = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
  const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
  const std::size_t mark = dsl::byte_order_mark.size();
  return begin == 0 && text.starts_with(dsl::byte_order_mark) && offset >= mark ? mark : begin;
}

/// Without its line break.
std::size_t line_end(std::string_view text, std::size_t offset) {
  const std::size_t end = std::min(text.find('\n', offset), text.size());
  return end > offset && text[end - 1] == '\r' ? end - 1 : end;
}

/// Whether the next line belongs to the line, or no compiler reads it as a whole one.
bool goes_on(std::string_view line) {
  while (!line.empty() && (line.back() == ' ' || line.back() == '\t' || line.back() == '\r')) line.remove_suffix(1);
  return line.ends_with('\\') || line.ends_with("?\?/");
}

} // namespace

std::string_view line_break(std::string_view text) {
  const std::size_t at = text.find('\n');
  return at != std::string_view::npos && at > 0 && text[at - 1] == '\r' ? "\r\n" : "\n";
}

std::string_view indentation(std::string_view text, std::size_t offset) {
  const std::size_t begin = line_begin(text, offset);
  const std::size_t end = std::min(text.find_first_not_of(" \t", begin), text.size());
  return text.substr(begin, end - begin);
}

std::size_t behind(std::string_view text, std::size_t end) {
  const std::size_t last = line_end(text, end);
  std::string_view rest = text.substr(end, last - end);
  if (goes_on(rest)) return end;
  while (!rest.empty()) {
    if (rest.front() == ' ' || rest.front() == '\t') {
      rest.remove_prefix(1);
    } else if (rest.starts_with("//")) {
      return last;
    } else if (rest.starts_with("/*") && rest.find("*/", 2) != std::string_view::npos) {
      rest.remove_prefix(rest.find("*/", 2) + 2);
    } else {
      return end;
    }
  }
  return last;
}

std::size_t before(std::string_view text, std::size_t offset) {
  const std::size_t begin = line_begin(text, offset);
  return text.substr(begin, offset - begin).find_first_not_of(" \t") == std::string_view::npos ? begin : offset;
}

std::size_t offset_at(std::string_view text, std::uint32_t line, std::uint32_t column) {
  std::size_t begin = 0;
  for (std::uint32_t next = 1; next < line; ++next) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string_view::npos) return text.size();
    begin = end + 1;
  }
  return std::min(begin + column - 1, text.size());
}

std::uint32_t line_of(std::string_view text, std::size_t offset) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(offset);
  return static_cast<std::uint32_t>(1 + std::count(text.begin(), end, '\n'));
}

} // namespace director::compiler::stubs
