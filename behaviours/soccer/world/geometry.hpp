#pragma once
// SPDX-License-Identifier: MIT
// Shape: points, turned points and angles of the soccer world, in whole numbers only, so that equal input gives equal
// bytes whatever the compiler does with floating point. Units: millimetres (Point), hundredths of a degree (Angle,
// counterclockwise, 0 along x). Errors: none. Source: Bhaskara's sine, off by less than 0.002; a quadratic arc tangent,
// off by less than a quarter of a degree.

#include <cstdint>

namespace sim {

using Angle = int;
using Milliseconds = int;

inline constexpr Angle degree = 100;
inline constexpr Angle half_turn = 180 * degree;

struct Point {
  int x = 0, y = 0;
  constexpr bool operator==(const Point&) const = default;
  constexpr Point operator+(Point other) const { return {x + other.x, y + other.y}; }
  constexpr Point operator-(Point other) const { return {x - other.x, y - other.y}; }
};

inline constexpr int one = 10'000; ///< what sine and cosine call 1

/// Into (-half_turn, half_turn].
constexpr Angle wrapped(Angle angle) {
  angle %= 2 * half_turn;
  if (angle > half_turn) return angle - 2 * half_turn;
  return angle <= -half_turn ? angle + 2 * half_turn : angle;
}

constexpr int sine(Angle angle) {
  angle = wrapped(angle);
  const std::int64_t x = angle < 0 ? -angle : angle;
  const std::int64_t product = x * (half_turn - x);
  const auto value = static_cast<int>(4 * one * product / (405'000'000 - product));
  return angle < 0 ? -value : value;
}

constexpr int cosine(Angle angle) { return sine(angle + half_turn / 2); }

constexpr int scaled(std::int64_t value, std::int64_t factor, std::int64_t divisor) {
  return static_cast<int>(value * factor / divisor);
}

constexpr Point turned(Point p, Angle by) {
  const int s = sine(by), c = cosine(by);
  return {scaled(p.x, c, one) - scaled(p.y, s, one), scaled(p.x, s, one) + scaled(p.y, c, one)};
}

constexpr int length(Point p) {
  const std::int64_t square = std::int64_t{p.x} * p.x + std::int64_t{p.y} * p.y;
  std::int64_t root = 0;
  for (std::int64_t bit = std::int64_t{1} << 31; bit != 0; bit >>= 1)
    if ((root + bit) * (root + bit) <= square) root += bit;
  return static_cast<int>(root);
}

/// The direction from the origin to p; 0 for the origin itself.
constexpr Angle bearing(Point p) {
  const std::int64_t x = p.x < 0 ? -p.x : p.x, y = p.y < 0 ? -p.y : p.y;
  if (x == 0 && y == 0) return 0;
  const bool steep = y > x;
  const std::int64_t z = steep ? x * one / y : y * one / x; // tangent of at most 45 degrees
  const auto small = static_cast<Angle>((4500 * z + 1564 * z * (one - z) / one) / one);
  const Angle quarter = steep ? half_turn / 2 - small : small;
  const Angle half = p.x < 0 ? half_turn - quarter : quarter;
  return p.y < 0 ? -half : half;
}

constexpr int clamped(int value, int most) { return value > most ? most : value < -most ? -most : value; }

} // namespace sim
