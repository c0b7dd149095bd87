#pragma once
// SPDX-License-Identifier: MIT
// Times as the language writes them: a whole number and a unit, `500 ms`.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace director::dsl {

enum class TimeUnit { us, ms, s, min };

struct Duration {
  std::int64_t amount = 0; ///< in `unit`, as written
  TimeUnit unit = TimeUnit::us;
  std::int64_t microseconds() const; ///< at most longest_duration: parse_duration refuses what is longer
  bool operator==(const Duration&) const = default;
};

constexpr std::int64_t longest_duration = 1'000'000'000'000'000'000; ///< microseconds; some 31,700 years

/// Empty unless `text` is a whole number from 0 and a unit, with nothing but blanks between and around them; also if it
/// is longer than a duration may be.
std::optional<Duration> parse_duration(std::string_view text);

/// The longest duration in the unit of `text`, if `text` is a duration that is too long.
std::optional<Duration> most_instead_of(std::string_view text);

std::string to_text(const Duration& duration); ///< `500 ms`

/// In seconds, milliseconds or microseconds: the largest of these units that leaves no rest.
Duration in_largest_unit(std::int64_t microseconds);
std::string time_text(std::int64_t microseconds); ///< in that unit

} // namespace director::dsl
