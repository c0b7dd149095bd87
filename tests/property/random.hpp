#pragma once
// SPDX-License-Identifier: MIT
// Random numbers that are the same on every machine: the distributions of the standard library are not.

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

namespace director::property {

class Random {
public:
  explicit Random(std::uint64_t seed) : state_(seed * 2 + 1) {
    for (int i = 0; i < 8; ++i) next();
  }

  /// SplitMix64 (Steele, Lea, Flood 2014).
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  /// A number from 0 to below `count`, which is above 0.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }
  /// A number in this range, both ends included.
  int between(int low, int high) { return low + static_cast<int>(below(static_cast<std::size_t>(high - low + 1))); }
  bool chance(double share) { return static_cast<double>(next() >> 11) * 0x1p-53 < share; }

  template <class T>
  const T& one_of(const std::vector<T>& items) {
    return items[below(items.size())];
  }
  template <class T>
  T one_of(std::initializer_list<T> items) {
    return items.begin()[below(items.size())];
  }
  /// At most `high` different ones, in random order.
  template <class T>
  std::vector<T> some(std::vector<T> items, int low, int high) {
    for (std::size_t i = 0; i + 1 < items.size(); ++i) std::swap(items[i], items[i + below(items.size() - i)]);
    const auto count = static_cast<std::size_t>(between(low, high));
    if (items.size() > count) items.resize(count);
    return items;
  }

private:
  std::uint64_t state_;
};

} // namespace director::property
