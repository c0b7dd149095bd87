#pragma once
// SPDX-License-Identifier: MIT
// The way of events from the thread that steps a behaviour to the one that writes them: a ring of fixed size with one
// writer and one reader. Who steps never waits, allocates or locks; what finds the ring full is counted, and the count
// travels with the next event that finds a place, so that the reader knows where something is missing.

#include "runtime/core/base/observer.hpp"

#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace director {

static_assert(std::is_trivially_copyable_v<Event>);

class EventQueue {
public:
  struct Entry {
    Event event;
    std::uint64_t dropped = 0; ///< events that found no place before this one, since the beginning
  };

  /// `size`: how many events can wait; rounded up to a power of two, 2 at least.
  explicit EventQueue(std::size_t size) : ring_(std::bit_ceil(size < 2 ? 2 : size)) {}
  EventQueue(const EventQueue&) = delete;
  EventQueue& operator=(const EventQueue&) = delete;

  // For the thread that steps.

  /// False: the queue is full.
  bool put(const Event& event) {
    const std::uint64_t end = end_.load(std::memory_order_relaxed);
    if (end - seen_begin_ == ring_.size()) {
      seen_begin_ = begin_.load(std::memory_order_acquire);
      if (end - seen_begin_ == ring_.size()) return false;
    }
    ring_[end & (ring_.size() - 1)] = {event, dropped_.load(std::memory_order_relaxed)};
    end_.store(end + 1, std::memory_order_release);
    return true;
  }
  /// An event is given up.
  void drop() { dropped_.store(dropped_.load(std::memory_order_relaxed) + 1, std::memory_order_release); }

  /// How many events were put or dropped so far.
  std::uint64_t told() const { return end_.load(std::memory_order_relaxed) + dropped_.load(std::memory_order_relaxed); }

  /// For the thread that writes: calls `use(entry)` for each entry that waits, and gives their places back at the end.
  template <class Use>
  std::size_t take(Use use) {
    const std::uint64_t begin = begin_.load(std::memory_order_relaxed), end = end_.load(std::memory_order_acquire);
    for (std::uint64_t i = begin; i != end; ++i) use(ring_[i & (ring_.size() - 1)]);
    begin_.store(end, std::memory_order_release);
    return static_cast<std::size_t>(end - begin);
  }

  /// Events that found no place, so far; from any thread.
  std::uint64_t dropped() const { return dropped_.load(std::memory_order_acquire); }

private:
  std::vector<Entry> ring_;
  std::uint64_t seen_begin_ = 0; ///< of the thread that steps: where the reader was when it looked last
  alignas(64) std::atomic<std::uint64_t> begin_{0}; ///< only the reader moves it
  alignas(64) std::atomic<std::uint64_t> end_{0};   ///< only the thread that steps moves it
  std::atomic<std::uint64_t> dropped_{0};
};

} // namespace director
