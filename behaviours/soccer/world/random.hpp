#pragma once
// SPDX-License-Identifier: MIT
// Shape: a small generator of pseudo-random numbers that is the same on every machine. Errors: none.
// Source: SplitMix64 (Steele, Lea, Flood 2014).

#include <cstdint>

namespace sim {

class Random {
public:
  constexpr explicit Random(std::uint64_t seed) : state_(seed) {}

  constexpr std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// From least to most, both included. The bias is far below what a soccer game could show.
  constexpr int between(int least, int most) {
    const auto count = static_cast<std::uint64_t>(std::int64_t{most} - least + 1);
    return static_cast<int>(least + static_cast<std::int64_t>(next() % count));
  }

private:
  std::uint64_t state_;
};

} // namespace sim
