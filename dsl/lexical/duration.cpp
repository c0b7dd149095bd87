// Header: dsl/lexical/duration.hpp. Test: tests/dsl/lexical/duration_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/lexical/duration.hpp"

#include "dsl/lexical/characters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace director::dsl {

namespace {

/// Its largest amount has only nines, so that a pattern of the JSON schemas can express the limit, and is within
/// longest_duration.
struct Unit {
  TimeUnit unit;
  std::string_view name;
  std::int64_t microseconds;
  std::int64_t most;
};
constexpr std::array units{
    Unit{TimeUnit::us, "us", 1, 999'999'999'999'999'999}, Unit{TimeUnit::ms, "ms", 1'000, 999'999'999'999'999},
    Unit{TimeUnit::s, "s", 1'000'000, 999'999'999'999}, Unit{TimeUnit::min, "min", 60'000'000, 9'999'999'999}};

constexpr const Unit& row(TimeUnit unit) { return units[static_cast<std::size_t>(unit)]; }

struct Written {
  std::optional<std::int64_t> amount; ///< nothing: it is beyond all bounds
  const Unit* unit = nullptr;         ///< null: this is no duration
};

Written take_apart(std::string_view text) {
  text = trimmed(text);
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  if (digits == 0 || (digits > 1 && text[0] == '0')) return {};
  const std::string_view name = trimmed(text.substr(digits));
  const auto unit = std::find_if(units.begin(), units.end(), [&](const Unit& each) { return each.name == name; });
  if (unit == units.end()) return {};
  std::int64_t amount = 0;
  const bool fits = std::from_chars(text.data(), text.data() + digits, amount).ec == std::errc();
  return {fits && amount <= unit->most ? std::optional(amount) : std::nullopt, &*unit};
}

} // namespace

std::int64_t Duration::microseconds() const { return amount * row(unit).microseconds; }

std::optional<Duration> parse_duration(std::string_view text) {
  const Written written = take_apart(text);
  return written.amount ? std::optional(Duration{*written.amount, written.unit->unit}) : std::nullopt;
}

std::optional<Duration> most_instead_of(std::string_view text) {
  const Written written = take_apart(text);
  if (written.unit == nullptr || written.amount) return std::nullopt;
  return Duration{written.unit->most, written.unit->unit};
}

std::string to_text(const Duration& duration) { return fmt::format("{} {}", duration.amount, row(duration.unit).name); }

Duration in_largest_unit(std::int64_t microseconds) {
  for (const TimeUnit unit : {TimeUnit::s, TimeUnit::ms}) {
    if (const std::int64_t each = row(unit).microseconds; microseconds % each == 0) return {microseconds / each, unit};
  }
  return {microseconds, TimeUnit::us};
}

std::string time_text(std::int64_t microseconds) { return to_text(in_largest_unit(microseconds)); }

} // namespace director::dsl
