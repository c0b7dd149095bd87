#pragma once
// SPDX-License-Identifier: MIT
// A set of the values that have occurred. They are contiguous, with a hash table of their places: adding one, or
// clearing, hardly ever allocates.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

namespace director::analysis {

template <class T>
class Seen {
  static_assert(std::has_unique_object_representations_v<T>, "it is hashed and compared as the bytes that it is");

public:
  /// True if it is new.
  bool add(const T& value) {
    if (2 * values_.size() >= slots_.size()) grow();
    std::uint32_t& slot = slots_[slot_of(value)];
    if (slot != empty) return false;
    slot = static_cast<std::uint32_t>(values_.size());
    values_.push_back(value);
    return true;
  }
  void clear() {
    slots_.assign(fewest_slots, empty);
    values_.clear();
  }
  std::size_t size() const { return values_.size(); }

private:
  static constexpr std::uint32_t empty = 0xffff'ffffU;
  static constexpr std::size_t fewest_slots = 64; ///< like all sizes a power of two

  /// Where it is, or would be: linear probing.
  std::size_t slot_of(const T& value) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = hash(value) & mask;
    while (slots_[at] != empty && std::memcmp(&values_[slots_[at]], &value, sizeof value) != 0) at = (at + 1) & mask;
    return at;
  }
  void grow() {
    slots_.assign(2 * slots_.size(), empty);
    for (std::size_t i = 0; i < values_.size(); ++i) slots_[slot_of(values_[i])] = static_cast<std::uint32_t>(i);
  }
  static std::size_t hash(const T& value) {
    std::uint64_t out = 0;
    for (std::size_t at = 0; at < sizeof value; at += sizeof(std::uint64_t)) {
      std::uint64_t word = 0;
      std::memcpy(&word, reinterpret_cast<const char*>(&value) + at, std::min(sizeof word, sizeof value - at));
      out = (out ^ word) * 0x9e37'79b9'7f4a'7c15U;
      out ^= out >> 32;
    }
    return static_cast<std::size_t>(out);
  }

  std::vector<T> values_;
  std::vector<std::uint32_t> slots_ = std::vector<std::uint32_t>(fewest_slots, empty);
};

} // namespace director::analysis
