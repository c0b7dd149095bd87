#pragma once
// SPDX-License-Identifier: MIT

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

namespace post {

enum class Mood : std::uint8_t { calm = 7, hurried = 3 };

/// Can be moved and not copied.
struct Parcel {
  std::unique_ptr<int> weight;
};

struct Steps {
  int count = 0;
};

/// Must be aligned, counts its instances, and reports its end if it was not moved on.
struct alignas(64) Wax {
  explicit Wax(int given, std::function<void()> at_end = {}) : grams(given), used_up(std::move(at_end)) { ++alive; }
  Wax(Wax&& other) noexcept : grams(other.grams), used_up(std::exchange(other.used_up, {})) { ++alive; }
  Wax& operator=(Wax&&) = delete;
  ~Wax() {
    --alive;
    if (used_up) used_up();
  }
  int grams;
  std::function<void()> used_up;
  static inline int alive = 0;
};

} // namespace post
