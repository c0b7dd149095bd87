// Door: dsl/duration.hpp. Test: tests/dsl/duration_test.cpp.
#include "dsl/duration.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <limits>
#include <utility>

namespace director::dsl {

namespace {

struct Unit {
  TimeUnit unit;
  std::string_view name;
  std::int64_t microseconds;
};
constexpr std::array units{Unit{TimeUnit::us, "us", 1}, Unit{TimeUnit::ms, "ms", 1'000},
                           Unit{TimeUnit::s, "s", 1'000'000}, Unit{TimeUnit::min, "min", 60'000'000}};

constexpr const Unit& row(TimeUnit unit) { return units[static_cast<std::size_t>(unit)]; }

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

} // namespace

std::int64_t Duration::microseconds() const { return amount * row(unit).microseconds; }

std::optional<Duration> parse_duration(std::string_view text) {
  text = trimmed(text);
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  std::int64_t amount = 0;
  if (std::from_chars(text.data(), text.data() + digits, amount).ec != std::errc() || (digits > 1 && text[0] == '0'))
    return std::nullopt;
  const std::string_view name = trimmed(text.substr(digits));
  for (const Unit& unit : units)
    if (unit.name == name && amount <= std::numeric_limits<std::int64_t>::max() / unit.microseconds)
      return Duration{amount, unit.unit};
  return std::nullopt;
}

std::string to_text(const Duration& duration) { return fmt::format("{} {}", duration.amount, row(duration.unit).name); }

} // namespace director::dsl
