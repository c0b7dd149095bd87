#pragma once
// Where the data of tasks lie: in slots inside the Behaviour, without heap. Each way of requesting a task has a slot
// and a staging slot, its group one more for the data of a request that has been replaced while the group lives on it.
// Root requests wait in slots of their own until the engine takes them from the inbox.

#include "runtime/core/run.hpp"
#include "runtime/core/task.hpp"

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>

namespace director {

/// Room for one value, which may be there or not.
template <class T>
class Slot {
public:
  Slot() = default;
  Slot(const Slot&) = delete;
  Slot& operator=(const Slot&) = delete;
  ~Slot() { clear(); }

  void put(T&& value) noexcept {
    clear();
    ::new (static_cast<void*>(room_)) T(std::move(value));
    full_ = true;
  }
  void take_from(Slot& other) noexcept {
    if (!other.full_) return clear();
    put(std::move(other.value()));
    other.clear();
  }
  void clear() noexcept {
    if (full_) value().~T();
    full_ = false;
  }
  bool full() const { return full_; }
  T& value() { return *std::launder(reinterpret_cast<T*>(room_)); }
  const T& value() const { return *std::launder(reinterpret_cast<const T*>(room_)); }

private:
  alignas(T) std::byte room_[sizeof(T)];
  bool full_ = false;
};

/// The data of one group's task. `places`: the number of edges by which it can be requested; a place is such an edge.
template <TaskType Task, std::size_t places>
class Slots {
  using Data = typename TaskBase<Task>::Type;

public:
  void stage(Index place, Data&& data) noexcept { staged_[place].put(std::move(data)); }
  void settle(Index place) noexcept { settled_[place].take_from(staged_[place]); }
  void retain(Index place) noexcept { retained_.take_from(settled_[place]); }

  const Data& at(DataPlace::Slot slot, Index place) const {
    switch (slot) {
    case DataPlace::Slot::edge: return settled_[place].value();
    case DataPlace::Slot::staging: return staged_[place].value();
    case DataPlace::Slot::group: break;
    }
    return retained_.value();
  }

private:
  std::array<Slot<Data>, places> settled_, staged_;
  Slot<Data> retained_;
};

/// How many requests of one root task with data can wait in the inbox at once. One more is refused, until the next step
/// has taken those that wait: the same answer as when the inbox is full.
inline constexpr std::size_t waiting_requests = 4;

/// The data of requests of one root task that wait in the inbox. Many writers, one reader; needs what Inbox needs.
template <TaskType Task>
class Waiting {
  using Data = typename TaskBase<Task>::Type;

public:
  /// From any thread: a place for the data, or nil if all are taken.
  Index put(Data&& data) noexcept {
    std::uint32_t taken = taken_.load(std::memory_order_relaxed);
    for (;;) {
      const auto place = static_cast<Index>(std::countr_one(taken));
      if (place >= waiting_requests) return nil;
      if (!taken_.compare_exchange_weak(taken, taken | (1U << place), std::memory_order_acquire)) continue;
      slots_[place].put(std::move(data));
      return place;
    }
  }
  Data& value(Index place) { return slots_[place].value(); }
  void free(Index place) noexcept {
    slots_[place].clear();
    taken_.fetch_and(~(1U << place), std::memory_order_release);
  }

private:
  std::array<Slot<Data>, waiting_requests> slots_;
  std::atomic<std::uint32_t> taken_{0};
};

} // namespace director
