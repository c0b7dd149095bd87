// Header: dsl/source/shortened.hpp. Test: tests/dsl/source/shortened_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/source/shortened.hpp"

#include "dsl/source/display_width.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::dsl {

namespace {

/// Keeps the beginning and the end, three to one, and cuts no character in two.
std::string cut(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  constexpr std::string_view mark = "…";
  const std::size_t kept = most - mark.size();
  std::size_t begin = kept * 3 / 4, end = text.size() - (kept - begin);
  while (begin > 0 && continues_character(text[begin])) --begin;
  while (end < text.size() && continues_character(text[end])) ++end;
  return fmt::format("{}{}{}", text.substr(0, begin), mark, text.substr(end));
}

} // namespace

std::string shortened(std::string_view message) {
  if (message.size() <= longest_quotation) return std::string(message);
  std::string out;
  std::size_t at = 0;
  while (true) {
    const std::size_t open = message.find('`', at);
    const std::size_t close = open == message.npos ? open : message.find('`', open + 1);
    if (close == message.npos) break;
    out += message.substr(at, open + 1 - at);
    out += cut(message.substr(open + 1, close - open - 1), longest_quotation);
    out += '`';
    at = close + 1;
  }
  out += message.substr(at);
  return cut(out, longest_message);
}

std::string shortened_list(const std::vector<std::string>& names) {
  const std::size_t shown = std::min(names.size(), most_names_listed);
  std::string out =
      fmt::format("{}", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
  if (shown < names.size()) out += fmt::format(" and {} more", names.size() - shown);
  return out;
}

} // namespace director::dsl
