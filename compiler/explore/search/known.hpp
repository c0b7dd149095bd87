#pragma once
// SPDX-License-Identifier: MIT
// The states that a search has found, by key. A key is never 0.
//
// A failed lookup waits for memory longer than a micro-step computes: so if a key is known early, its place is
// prefetched.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace director::compiler {

/// Of a state, in the order of discovery.
using Number = std::uint32_t;
inline constexpr Number none = static_cast<Number>(-1);

/// Key -> number, by open addressing; at most three quarters full. The keys are separate from the numbers, which are
/// rarely read.
class KeyTable {
public:
  explicit KeyTable(std::size_t slots = 1U << 8) : keys_(slots), numbers_(slots) {}
  void fetch(std::uint64_t key) const { __builtin_prefetch(&keys_[key & mask()]); }
  bool has(std::uint64_t key) const { return keys_[place(key)] == key; }
  Number find(std::uint64_t key) const {
    const std::size_t at = place(key);
    return keys_[at] == key ? numbers_[at] : none;
  }
  /// Adds a key that is not there.
  void add(std::uint64_t key, Number number) {
    if (++count_ * 4 > keys_.size() * 3) grow();
    put(key, number);
  }
  void clear() {
    std::fill(keys_.begin(), keys_.end(), 0);
    count_ = 0;
  }
  std::size_t bytes() const { return keys_.size() * (sizeof(std::uint64_t) + sizeof(Number)); }

private:
  std::size_t mask() const { return keys_.size() - 1; }
  /// The place of the key, or where it would be.
  std::size_t place(std::uint64_t key) const {
    std::size_t at = key & mask();
    while (keys_[at] != key && keys_[at] != 0) at = (at + 1) & mask();
    return at;
  }
  void put(std::uint64_t key, Number number) {
    const std::size_t at = place(key);
    keys_[at] = key;
    numbers_[at] = number;
  }
  void grow() {
    KeyTable old(keys_.size() * 2);
    std::swap(old.keys_, keys_);
    std::swap(old.numbers_, numbers_);
    for (std::size_t i = 0; i < old.keys_.size(); ++i) {
      if (old.keys_[i] != 0) put(old.keys_[i], old.numbers_[i]);
    }
  }
  std::vector<std::uint64_t> keys_; ///< slot; 0: nothing
  std::vector<Number> numbers_;
  std::size_t count_ = 0;
};

/// The same in sixteen parts by the first bits of the key, of which one at a time grows: so growing needs a sixteenth
/// more memory for a moment, and not half as much again.
class Known {
public:
  void fetch(std::uint64_t key) const { part(key).fetch(key); }
  bool has(std::uint64_t key) const { return part(key).has(key); }
  Number find(std::uint64_t key) const { return part(key).find(key); }
  void add(std::uint64_t key, Number number) {
    KeyTable& to = parts_[key >> 60];
    bytes_ -= to.bytes();
    to.add(key, number);
    bytes_ += to.bytes();
  }
  std::size_t bytes() const { return bytes_; }

private:
  const KeyTable& part(std::uint64_t key) const { return parts_[key >> 60]; }
  std::array<KeyTable, 16> parts_;
  std::size_t bytes_ = parts_.size() * parts_.front().bytes();
};

/// A cache of micro-steps that were taken (Machine::foresee) -> in how many ways each can end. A new entry replaces the
/// old one in its place.
class PlayedTable {
public:
  static constexpr std::size_t most_slots = 1U << 22;

  explicit PlayedTable(std::size_t slots) : slots_(slots) {}
  void fetch(std::uint64_t key) const { __builtin_prefetch(&slots_[key & mask()]); }
  /// 0: not known.
  std::size_t find(std::uint64_t key) const {
    const std::uint64_t slot = slots_[key & mask()];
    return ((slot ^ key) & ~low) == 0 ? slot & low : 0;
  }
  void add(std::uint64_t key, std::size_t ways) {
    if (ways <= low) slots_[key & mask()] = (key & ~low) | ways;
  }
  /// To a power of two, at least 2^8, so that place and slot together determine the whole key.
  void grow(std::size_t slots) {
    std::vector<std::uint64_t> old(slots);
    old.swap(slots_);
    for (std::size_t i = 0; i < old.size(); ++i) {
      if ((old[i] & low) != 0) slots_[((old[i] & ~low) | (i & low)) & mask()] = old[i];
    }
  }
  std::size_t size() const { return slots_.size(); }
  std::size_t bytes() const { return slots_.size() * sizeof(std::uint64_t); }

private:
  static constexpr std::uint64_t low = 0xff;
  std::size_t mask() const { return slots_.size() - 1; }
  std::vector<std::uint64_t> slots_;
};

} // namespace director::compiler
