// Header: tests/docs/comment.hpp. Test: tests/docs/expected_page_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/docs/comment.hpp"

#include <algorithm>

namespace director::tests {

namespace {

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

/// Removes the part before the next comma or colon from the text, but not one between quotation marks.
std::string_view take(std::string_view& text) {
  bool quoted = false;
  std::size_t end = 0;
  for (; end < text.size(); ++end) {
    if (text[end] == '"') quoted = !quoted;
    if (!quoted && (text[end] == ',' || text[end] == ':')) break;
  }
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(end);
  return trimmed(taken);
}

} // namespace

Comment read_comment(std::string_view text) {
  Comment comment;
  const std::size_t end = std::min(text.find('\n'), text.size());
  comment.rest = text.substr(std::min(end + 1, text.size()));
  text = text.substr(0, end);
  comment.word = take(text);
  while (text.starts_with(',')) {
    text.remove_prefix(1);
    const std::string_view option = take(text);
    const std::size_t space = std::min(option.find(' '), option.size());
    std::string_view value = trimmed(option.substr(space));
    if (value.size() > 1 && value.starts_with('"') && value.ends_with('"')) value = value.substr(1, value.size() - 2);
    comment.options[std::string(option.substr(0, space))] = value;
  }
  if (text.starts_with(':')) comment.argument = trimmed(text.substr(1));
  return comment;
}

} // namespace director::tests
