// Header: dsl/lexical/numbers.hpp. Test: tests/dsl/reading/read_data_test.cpp, tests/dsl/data_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/lexical/numbers.hpp"

#include "dsl/lexical/characters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace director::dsl {

namespace {

std::string_view without_sign(std::string_view text) {
  return text.substr(text.starts_with('-') || text.starts_with('+') ? 1 : 0);
}

} // namespace

std::optional<std::string> integer_of_yaml(std::string_view text) {
  std::string_view digits = without_sign(text);
  const bool octal = text.starts_with("0o"), hexadecimal = text.starts_with("0x");
  if (octal || hexadecimal) {
    std::uint64_t value = 0;
    const auto [end, failed] = std::from_chars(text.data() + 2, text.data() + text.size(), value, octal ? 8 : 16);
    if (failed != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return fmt::format("{}", value);
  }
  if (!all_among(digits, "0123456789")) return std::nullopt;
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size() - 1));
  return fmt::format("{}{}", text.starts_with('-') && digits != "0" ? "-" : "", digits);
}

std::optional<std::string> real_of_yaml(std::string_view text) {
  const std::string_view digits = without_sign(text);
  if (!all_among(digits, "0123456789.eE+-") || digits.find_first_of("0123456789") > 1) return std::nullopt;
  const std::string_view number = text.starts_with('+') ? digits : text;
  double value = 0;
  const auto [end, failed] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (failed != std::errc() || end != number.data() + number.size()) return std::nullopt;
  const std::string shortest = fmt::format("{}", value);
  return shortest.find_first_of(".e") == std::string::npos ? shortest + ".0" : shortest;
}

} // namespace director::dsl
