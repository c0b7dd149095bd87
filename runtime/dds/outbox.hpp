#pragma once
// SPDX-License-Identifier: MIT
// A fixed ring of events between the thread that steps and the one that writes to the network. The thread that steps
// never waits, allocates or locks; events that find the ring full are counted.

#include "runtime/core/base/observer.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace director::dds {

class Outbox {
public:
  struct Entry {
    Event event;
    std::uint64_t number = 0; ///< the number of the decision, from 1, including those dropped; 0: no decision, such as
                              ///< a state that was set
  };

  /// `room`: how many events can wait; rounded up to a power of two, 2 at least. `next` is called as well.
  explicit Outbox(std::size_t room = 1024, Observer next = {});
  Outbox(const Outbox&) = delete;
  Outbox& operator=(const Outbox&) = delete;

  /// For the behaviour's constructor. The outbox must live as long as the behaviour.
  Observer observer() {
    return {[](void* self, const Event& event) { static_cast<Outbox*>(self)->tell(event); }, this};
  }
  /// What the observer does, for a program with an observer of its own.
  void tell(const Event& event);

  // For the thread that writes.
  bool take(Entry& out);
  std::uint64_t lost() const { return lost_.load(std::memory_order_relaxed); }

  // For the thread that steps.
  bool anything_new() const { return end_.load(std::memory_order_relaxed) != seen_; }
  void all_seen() { seen_ = end_.load(std::memory_order_relaxed); }

private:
  void put(const Event& event, std::uint64_t number);

  // No vector: the layout must not depend on how the program is compiled (_GLIBCXX_DEBUG).
  const std::size_t room_;
  const std::unique_ptr<Entry[]> ring_;
  Observer next_;
  std::uint64_t number_ = 0; ///< of the last decision
  std::uint64_t seen_ = 0;
  std::atomic<std::uint64_t> begin_{0},
      end_{0}; ///< the events that wait; only the writer changes the first, only the thread that steps the other
  std::atomic<std::uint64_t> lost_{0};
};

} // namespace director::dds
