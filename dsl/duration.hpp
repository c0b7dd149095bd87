#pragma once
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
  std::int64_t microseconds() const; ///< always fits: parse_duration refuses what does not
  bool operator==(const Duration&) const = default;
};

/// Nothing unless `text` is a whole number from 0, a unit, and at most blanks between and around them.
std::optional<Duration> parse_duration(std::string_view text);

std::string to_text(const Duration& duration); ///< `500 ms`

} // namespace director::dsl
