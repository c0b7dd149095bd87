#pragma once
// SPDX-License-Identifier: MIT
// Durations in 64 bits: those of std::chrono, of any rep and period, are converted to microseconds, without its header.
// A result beyond the range of Time is its end, in a conversion and in a sum: the longest duration is `never`.

#include "runtime/core/base/tables.hpp"

#include <concepts>
#include <type_traits>

namespace director {

/// A duration of std::chrono, without its header.
template <class T>
concept Duration = requires(const T& duration) {
  duration.count();
  T::period::num;
  T::period::den;
};

/// The time after a duration. Nothing is later than `never`.
constexpr Time later(Time time, Time duration) { return time > never - duration ? never : time + duration; }

namespace detail {

constexpr Time greatest_divisor(Time a, Time b) { return b == 0 ? a : greatest_divisor(b, a % b); }

/// Microseconds in one tick of a clock: num / den.
template <class Period>
struct Tick {
  static constexpr Time second = 1'000'000;
  static constexpr Time common = greatest_divisor(second, Period::den);
  static constexpr Time den = Period::den / common;
  static constexpr bool endless = Period::num >
                                  never / (second / common); ///< one tick is longer than the range of Time
  static constexpr Time num = endless ? 1 : Period::num * (second / common);
  static_assert(num <= never / den, "microseconds cannot be made of this unit in 64 bits");
};

/// The nearest Time.
template <class Count>
constexpr Time saturated(Count count) {
  Time out = 0;
  return !__builtin_add_overflow(count, out, &out) ? out : count > 0 ? never : first_time;
}

/// `factor`: above 0.
constexpr Time saturated_product(Time count, Time factor) {
  if (count > never / factor) return never;
  return count < first_time / factor ? first_time : count * factor;
}

constexpr Time saturated_sum(Time a, Time b) {
  if (b > 0) return later(a, b);
  return a < first_time - b ? first_time : a + b;
}

template <class Tick, class Count>
constexpr Time whole_microseconds(Count count, bool up) {
  if constexpr (Tick::endless) return count > Count(0) ? never : count < Count(0) ? first_time : 0;
  using Wide = std::common_type_t<Count, Time>; // 64 bits at least, with a sign where the count has one
  const Wide ticks = count, den = static_cast<Wide>(Tick::den);
  const auto rest = static_cast<Time>(ticks % den) * Tick::num;
  const Time whole = saturated_sum(saturated_product(saturated(ticks / den), Tick::num), rest / Tick::den);
  return up && rest % Tick::den > 0 ? later(whole, 1) : whole;
}

/// Returns the first time for NaN.
template <class Tick, class Count>
constexpr Time microseconds_of_fraction(Count count, bool up) {
  using Wide = std::common_type_t<Count, double>;
  constexpr Wide end = 9223372036854775808.0; // 2 to the 63rd
  const Wide exact =
      static_cast<Wide>(count) * static_cast<Wide>(Tick::endless ? never : Tick::num) / static_cast<Wide>(Tick::den);
  if (exact >= end) return never;
  if (!(exact > -end)) return first_time;
  const auto whole = static_cast<Time>(exact);
  return up && static_cast<Wide>(whole) < exact ? later(whole, 1) : whole;
}

template <Duration T>
constexpr Time to_microseconds(const T& duration, bool up) {
  using Count = std::remove_cvref_t<decltype(duration.count())>;
  using Ticks = Tick<typename T::period>;
  if constexpr (std::is_floating_point_v<Count>) {
    return microseconds_of_fraction<Ticks>(duration.count(), up);
  } else {
    return whole_microseconds<Ticks>(duration.count(), up);
  }
}

} // namespace detail

/// Microseconds in a duration, rounded towards zero.
template <Duration T>
constexpr Time microseconds_begun(const T& duration) {
  return detail::to_microseconds(duration, false);
}

/// The same, rounded up, so that no wait is shorter than requested.
template <Duration T>
constexpr Time microseconds(const T& duration) {
  return detail::to_microseconds(duration, true);
}

} // namespace director
