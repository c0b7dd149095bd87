#pragma once
// SPDX-License-Identifier: MIT
// The memory for the data of tasks: slots inside the Behaviour, without heap. Each edge that leads to a task has a
// slot, its group one for the data of a request that was replaced while the group still uses them, and a staging slot:
// in one micro-step, at most one edge to the group is requested. Root requests have slots of their own until they are
// taken.

#include "runtime/core/api/task.hpp"
#include "runtime/core/engine/inbox.hpp"
#include "runtime/core/engine/run.hpp"

#include <new>
#include <utility>

namespace director {

/// Memory for at most one value.
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
    if (std::exchange(full_, false)) value().~T(); // empty before the destructor, which may call post()
  }

  /// A byte that says whether it is full, then the value, or zeros. For trivially copyable types.
  static constexpr std::size_t saved_bytes = 1 + sizeof(T);
  void save(std::byte* to) const {
    *to++ = full_ ? std::byte{1} : std::byte{0};
    for (const std::byte each : room_) *to++ = full_ ? each : std::byte{0};
  }
  void load(const std::byte* from) {
    full_ = *from++ != std::byte{0};
    for (std::byte& each : room_) each = *from++; // the bytes become a value
  }

  T& value() { return *std::launder(reinterpret_cast<T*>(room_)); }
  const T& value() const { return *std::launder(reinterpret_cast<const T*>(room_)); }

private:
  alignas(T) std::byte room_[sizeof(T)];
  bool full_ = false;
};

/// The data of one group's task. `places`: the number of edges that lead to it; a place is one of them.
template <TaskType Task, std::size_t places>
class Slots {
  static_assert(has_data<Task>, "`data: void`: a task without data has no `data`");
  using Data = typename TaskBase<Task>::data_type;

public:
  void stage(Data&& data) noexcept { staged_.put(std::move(data)); }
  void settle(Index place) noexcept { settled_[place].take_from(staged_); }
  void retain(Index place) noexcept { retained_.take_from(settled_[place]); }

  static constexpr std::size_t lasting = places + 1;
  /// Calls visit(slot) for each slot that holds data between steps: of each place, then of the group.
  template <class Visit>
  void each_lasting(Visit&& visit) {
    for (auto& slot : settled_) visit(slot);
    visit(retained_);
  }

  const Data& at(DataPlace::Slot slot, Index place) const {
    if (slot == DataPlace::Slot::edge) return settled_[place].value();
    return (slot == DataPlace::Slot::group ? retained_ : staged_).value();
  }

private:
  std::array<Slot<Data>, places> settled_;
  Slot<Data> retained_, staged_;
};

/// The data of requests of one root task that the engine has not taken yet. Many writers, one reader; needs the same
/// atomics as Inbox. First the places for requests in the inbox, then one for each place of the overflow slot.
template <TaskType Task>
class Waiting {
  using Data = typename TaskBase<Task>::data_type;

public:
  /// From any thread: stores the data of a request to be posted; returns the place, or nil if all are taken.
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
  /// The same for a record in an overflow slot, whose handle only the caller has.
  void put_at(Index handle, Data&& data) noexcept { slots_[handle].put(std::move(data)); }
  Data& value(Index handle) { return slots_[handle].value(); }
  /// Frees the slot; the handle of an overflow record becomes free with its place.
  void free(Index handle) noexcept {
    slots_[handle].clear();
    if (handle >= waiting_requests) return;
    std::uint32_t taken = taken_.load(std::memory_order_relaxed);
    while (!taken_.compare_exchange_weak(taken, taken & ~(1U << handle), std::memory_order_release)) {}
  }

private:
  std::array<Slot<Data>, waiting_requests + OverflowSlot::places> slots_;
  std::atomic<std::uint32_t> taken_{0};
};

} // namespace director
