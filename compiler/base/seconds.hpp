#pragma once
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace director::compiler {

/// "1.500000".
inline std::string in_seconds(std::int64_t microseconds) {
  const bool negative = microseconds < 0;
  const auto size = negative ? 0 - static_cast<std::uint64_t>(microseconds) : static_cast<std::uint64_t>(microseconds);
  return fmt::format("{}{}.{:06}", negative ? "-" : "", size / 1'000'000, size % 1'000'000);
}

/// "1.5 s", with all digits that are not 0. The time is not negative.
inline std::string exact_seconds(std::int64_t microseconds) {
  std::string out = in_seconds(microseconds);
  while (out.ends_with('0')) out.pop_back();
  if (out.ends_with('.')) out.pop_back();
  return out + " s";
}

/// "250 us", "1.5 s", "59 min 59.99 s", "1 h 0 min 3 s": at most three digits after the point, without trailing zeros.
inline std::string as_duration(std::uint64_t microseconds) {
  constexpr std::uint64_t thousand = 1000, minute = 60'000, hour = 60 * minute;
  const auto plain = [](double number) {
    std::string out = fmt::format("{:.3f}", number);
    out.erase(out.find_last_not_of('0') + 1);
    if (out.ends_with('.')) out.pop_back();
    return out;
  };
  if (microseconds < thousand && microseconds != 0) return fmt::format("{} us", microseconds);
  // To the millisecond first: otherwise 59.9996 s would become 60 s of a minute.
  const std::uint64_t rounded = microseconds / thousand + (microseconds % thousand >= thousand / 2 ? 1 : 0);
  std::string out;
  if (rounded >= hour) out += fmt::format("{} h ", rounded / hour);
  if (rounded >= minute) out += fmt::format("{} min ", rounded % hour / minute);
  return out + plain(static_cast<double>(rounded % minute) / 1e3) + " s";
}

} // namespace director::compiler
