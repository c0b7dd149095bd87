#pragma once
// SPDX-License-Identifier: MIT
// A queue of events from the thread that steps a behaviour to the one that writes them: a ring of fixed size with one
// writer and one reader. The thread that steps never waits, allocates or locks. Events that find the ring full are
// counted, and the count comes with the next event that is stored, so that the reader knows where events are missing.

#include "runtime/core/base/observer.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>

namespace director {

static_assert(std::is_trivially_copyable_v<Event>);

class EventQueue {
public:
  struct Entry {
    Event event;
    std::uint64_t dropped = 0; ///< events dropped before this one, since the beginning
  };

  /// `size`: how many events can wait; rounded up to a power of two, 2 at least. Errors: std::bad_alloc.
  explicit EventQueue(std::size_t size)
      : size_(std::bit_ceil(std::clamp(size, std::size_t{2}, std::numeric_limits<std::size_t>::max() / 2 + 1))),
        ring_(std::make_unique<Entry[]>(size_)) {}
  EventQueue(const EventQueue&) = delete;
  EventQueue& operator=(const EventQueue&) = delete;

  /// A queue of this size; without memory for it, of the smallest.
  static EventQueue with_room_for(std::size_t size) {
#ifdef __cpp_exceptions
    try {
      return EventQueue(size);
    } catch (const std::bad_alloc&) { return EventQueue(0); }
#else
    return EventQueue(size);
#endif
  }

  std::size_t size() const { return size_; } ///< how many events can wait

  // For the thread that steps.

  /// False: the queue is full.
  bool put(const Event& event) {
    const std::uint64_t end = end_.load(std::memory_order_relaxed);
    if (end - seen_begin_ == size_) {
      seen_begin_ = begin_.load(std::memory_order_acquire);
      if (end - seen_begin_ == size_) return false;
    }
    ring_[end & (size_ - 1)] = {event, dropped_.load(std::memory_order_relaxed)};
    end_.store(end + 1, std::memory_order_release);
    return true;
  }
  /// Drops an event.
  void drop() { dropped_.store(dropped_.load(std::memory_order_relaxed) + 1, std::memory_order_release); }

  /// The number of events put or dropped so far.
  std::uint64_t total() const {
    return end_.load(std::memory_order_relaxed) + dropped_.load(std::memory_order_relaxed);
  }

  /// For the thread that writes: calls `use(entry)` for each entry that waits, then frees their places; those of the
  /// entries used so far if `use` throws.
  template <class Use>
  std::size_t take(Use use) {
    struct Freed {
      std::atomic<std::uint64_t>& begin;
      std::uint64_t used;
      ~Freed() { begin.store(used, std::memory_order_release); }
    };
    const std::uint64_t begin = begin_.load(std::memory_order_relaxed), end = end_.load(std::memory_order_acquire);
    for (Freed freed{begin_, begin}; freed.used != end;) use(ring_[freed.used++ & (size_ - 1)]);
    return static_cast<std::size_t>(end - begin);
  }

  /// For the thread that writes: whether no entry waits.
  bool is_empty() const { return begin_.load(std::memory_order_relaxed) == end_.load(std::memory_order_acquire); }

  /// Events dropped so far; from any thread.
  std::uint64_t dropped() const { return dropped_.load(std::memory_order_acquire); }

private:
  // No vector: the layout must not depend on how the program is compiled (_GLIBCXX_DEBUG).
  std::size_t size_;
  std::unique_ptr<Entry[]> ring_;
  std::uint64_t seen_begin_ = 0; ///< used by the thread that steps: position of the reader when it was read last
  alignas(64) std::atomic<std::uint64_t> begin_{0}; ///< changed only by the reader
  alignas(64) std::atomic<std::uint64_t> end_{0};   ///< changed only by the thread that steps
  std::atomic<std::uint64_t> dropped_{0};
};

} // namespace director
