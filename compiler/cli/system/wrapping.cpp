// Header: compiler/cli/system/wrapping.hpp. Test: tests/compiler/cli/system/wrapping_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/system/wrapping.hpp"

#include "compiler/cli/system/page_text.hpp"

#include <algorithm>

namespace director::compiler::cli {

namespace {

/// `   12 | text`, `      | ^~~` or `  ... |`
bool shows_source(std::string_view line) {
  const std::size_t bar = line.find(" |");
  return bar != std::string_view::npos && bar >= 5 &&
         line.substr(0, bar).find_first_not_of(" .0123456789") == std::string_view::npos;
}

} // namespace

std::string wrapped_line(std::string_view line, std::size_t width) {
  constexpr std::size_t further = 4;
  if (shows_source(line)) return std::string(line);
  if (columns_of(line) <= width) return std::string(line);
  std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
  std::size_t indent = begin + further;
  // In a table only the last column is broken, within itself.
  const std::size_t gap = line.find_last_not_of(' ', line.rfind("  "));
  if (gap != std::string_view::npos && gap > begin) {
    const std::size_t last = line.find_first_not_of(' ', gap + 1), column = columns_of(line.substr(0, last));
    if (column <= width / 2) begin = last, indent = column;
  }
  if (indent + further >= width) return std::string(line);
  return std::string(line.substr(0, begin)) +
         in_lines(line.substr(begin), width, columns_of(line.substr(0, begin)), indent);
}

bool WrappingBuffer::put(std::string_view text) {
  return to_.sputn(text.data(), static_cast<std::streamsize>(text.size())) == static_cast<std::streamsize>(text.size());
}

std::streambuf::int_type WrappingBuffer::overflow(int_type letter) {
  if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
  const char text = traits_type::to_char_type(letter);
  return xsputn(&text, 1) == 1 ? letter : traits_type::eof();
}

std::streamsize WrappingBuffer::xsputn(const char* text, std::streamsize size) {
  std::string_view rest(text, static_cast<std::size_t>(size));
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    line_ += rest.substr(0, end);
    if (end == std::string_view::npos) break;
    if (!put((has_begun_ ? line_ : wrapped_line(line_, width_)) + "\n")) return 0;
    line_.clear();
    has_begun_ = false;
    rest.remove_prefix(end + 1);
  }
  return size;
}

int WrappingBuffer::sync() {
  has_begun_ = has_begun_ || !line_.empty();
  const bool good = put(line_);
  line_.clear();
  return to_.pubsync() == 0 && good ? 0 : -1;
}

} // namespace director::compiler::cli
