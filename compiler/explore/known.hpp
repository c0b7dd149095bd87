#pragma once
// What a search has found, by key. A key is never 0.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace director::compiler {

/// Of a state, in the order in which they were found.
using Number = std::uint32_t;
inline constexpr Number none = static_cast<Number>(-1);

/// Key -> number, by open addressing; at most half full.
class Known {
public:
  Known() : slots_(1U << 12) {}
  Number find(std::uint64_t key) const {
    for (std::size_t at = key & mask();; at = (at + 1) & mask()) {
      if (slots_[at].key == key || slots_[at].key == 0) return slots_[at].key == 0 ? none : slots_[at].number;
    }
  }
  void add(std::uint64_t key, Number number) {
    if (++count_ * 2 > slots_.size()) grow();
    put(key, number);
  }
  void clear() {
    std::fill(slots_.begin(), slots_.end(), Slot{});
    count_ = 0;
  }
  std::size_t bytes() const { return slots_.size() * sizeof(Slot); }

private:
  struct Slot {
    std::uint64_t key = 0;
    Number number = none;
  };
  std::size_t mask() const { return slots_.size() - 1; }
  void put(std::uint64_t key, Number number) {
    std::size_t at = key & mask();
    while (slots_[at].key != 0) at = (at + 1) & mask();
    slots_[at] = {key, number};
  }
  void grow() {
    std::vector<Slot> old(slots_.size() * 2);
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.key != 0) put(slot.key, slot.number);
    }
  }
  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

/// Micro-steps that were taken (Machine::foresee) -> in how many ways each can end. It forgets: who comes last stays.
class Played {
public:
  static constexpr std::size_t most_slots = 1U << 20;

  explicit Played(std::size_t slots) : slots_(slots) {}
  /// 0: not known.
  std::size_t find(std::uint64_t key) const {
    const std::uint64_t slot = slots_[key & mask()];
    return ((slot ^ key) & ~low) == 0 ? slot & low : 0;
  }
  void add(std::uint64_t key, std::size_t ways) {
    if (ways <= low) slots_[key & mask()] = (key & ~low) | ways;
  }
  /// To a power of two, at least 2^8, so that place and slot together tell the whole key.
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
