#pragma once
// SPDX-License-Identifier: MIT
// The way of whole moments from the thread that steps to the one that shows them: three buffers, one that is written,
// one that is read, and one between, which each side takes in exchange for its own. Nobody ever waits, and no moment is
// refused: what nobody looked at is written over.

#include "runtime/core/inspect/view.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace director::live {

/// What held after a step.
struct Moment {
  View view;              ///< of the copy; without tables: there is none yet
  std::uint64_t told = 0; ///< events that were told before it, those that were dropped among them
};

class Moments {
public:
  explicit Moments(const Tables& tables) : tables_(tables) {
    for (Buffer& buffer : buffers_) buffer.bytes.resize(View::bytes(Shape::of(tables)) / sizeof(std::uint64_t));
  }
  Moments(const Moments&) = delete;
  Moments& operator=(const Moments&) = delete;

  /// For the thread that steps. Copies only where a micro-step was taken since the last time.
  void show(const View& view, std::uint64_t told) {
    now_.store(view.now, std::memory_order_relaxed);
    if (view.micro_step == shown_) return;
    shown_ = view.micro_step;
    Buffer& buffer = buffers_[written_];
    buffer.moment = {view.copy(reinterpret_cast<std::byte*>(buffer.bytes.data())), told};
    buffer.moment.view.tables = &tables_; // the engine's own end with the behaviour, which the view outlives
    written_ = between_.exchange(static_cast<std::uint8_t>(written_ | fresh), std::memory_order_acq_rel) & place;
  }

  /// For the thread that shows: the newest moment, which stays as it is until the next call.
  const Moment& look() {
    if ((between_.load(std::memory_order_relaxed) & fresh) != 0)
      read_ = between_.exchange(read_, std::memory_order_acq_rel) & place;
    return buffers_[read_].moment;
  }

  /// From any thread: the engine's time when `show` was called last.
  Time now() const { return now_.load(std::memory_order_relaxed); }

private:
  struct Buffer {
    std::vector<std::uint64_t> bytes;
    Moment moment;
  };
  static constexpr std::uint8_t place = 3, fresh = 4;

  const Tables& tables_;
  std::array<Buffer, 3> buffers_;
  std::uint64_t shown_ =
      ~std::uint64_t{0}; ///< the micro-step of the last moment; of the thread that steps, as is the next
  std::uint8_t written_ = 0;
  std::uint8_t read_ = 1; ///< of the thread that shows
  std::atomic<std::uint8_t> between_{2};
  std::atomic<Time> now_{0};
};

} // namespace director::live
