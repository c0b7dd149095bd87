#pragma once
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace director::compiler {

inline std::string_view plural_end(std::uint64_t count, std::string_view one) {
  return count == 1 ? "" : one.ends_with('s') || one.ends_with("sh") ? "es" : "s";
}

/// "1 push", "3 pushes".
inline std::string counted(std::uint64_t count, std::string_view one) {
  return fmt::format("{} {}{}", count, one, plural_end(count, one));
}

/// "1,587,146 events".
inline std::string many_counted(std::uint64_t count, std::string_view one) {
  std::string digits = std::to_string(count);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, ",");
  return fmt::format("{} {}{}", digits, one, plural_end(count, one));
}

/// "1 push is", "3 pushes are".
inline std::string counted_are(std::uint64_t count, std::string_view one) {
  return counted(count, one) + (count == 1 ? " is" : " are");
}

} // namespace director::compiler
