#pragma once
// SPDX-License-Identifier: MIT

#include <cstdint>
#include <memory>

namespace post {

enum class Mood : std::uint8_t { calm = 7, hurried = 3 };

/// Can be moved and not copied.
struct Parcel {
  std::unique_ptr<int> weight;
};

struct Steps {
  int count = 0;
};

/// Must be aligned, and counts its instances.
struct alignas(64) Wax {
  explicit Wax(int given) : grams(given) { ++alive; }
  Wax(Wax&& other) noexcept : grams(other.grams) { ++alive; }
  Wax& operator=(Wax&&) = delete;
  ~Wax() { --alive; }
  int grams;
  static inline int alive = 0;
};

} // namespace post
