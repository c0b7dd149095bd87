#pragma once
// SPDX-License-Identifier: MIT
// A triple buffer of moments between the thread that steps and the one that shows them: one buffer is written, one is
// read, and each side exchanges its own for the third. No thread ever waits, and no moment is refused: a moment that
// was not read is overwritten.

#include "runtime/core/inspect/view.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace director::live {

/// The state after a step.
struct Moment {
  View view;                ///< of the copy; without tables there is none yet
  std::uint64_t events = 0; ///< events before it, including those that were dropped
};

class Moments {
public:
  explicit Moments(const Tables& tables) : tables_(tables) {
    const std::size_t words = View::bytes(Shape::of(tables)) / sizeof(std::uint64_t);
    for (Buffer& buffer : buffers_) buffer.bytes = std::make_unique<std::uint64_t[]>(words);
  }
  Moments(const Moments&) = delete;
  Moments& operator=(const Moments&) = delete;

  /// For the thread that steps. Copies only if something happened since the last call, which may be a load.
  void show(const View& view, std::uint64_t events) {
    now_.store(view.now, std::memory_order_relaxed);
    if (view.micro_step == shown_ && view.passes == passes_ && events == events_)
      return buffers_[newest_].until.store(view.now, std::memory_order_relaxed);
    shown_ = view.micro_step;
    passes_ = view.passes;
    events_ = events;
    Buffer& buffer = buffers_[written_];
    buffer.moment = {view.copy(reinterpret_cast<std::byte*>(buffer.bytes.get())), events};
    buffer.moment.view.tables = &tables_; // those of the engine end with the behaviour, before the view
    buffer.until.store(view.now, std::memory_order_relaxed);
    newest_ = written_;
    written_ = between_.exchange(static_cast<std::uint8_t>(written_ | fresh), std::memory_order_acq_rel) & place;
  }

  /// For the thread that shows: the newest moment, unchanged until the next call.
  const Moment& look() {
    if ((between_.load(std::memory_order_relaxed) & fresh) != 0)
      read_ = between_.exchange(read_, std::memory_order_acq_rel) & place;
    return buffers_[read_].moment;
  }

  /// For that thread: the engine's time at the last `show` of that moment, after which something else was shown, if
  /// anything.
  Time until() const { return buffers_[read_].until.load(std::memory_order_relaxed); }

  /// From any thread: the engine's time at the last `show`.
  Time now() const { return now_.load(std::memory_order_relaxed); }

private:
  struct Buffer {
    std::unique_ptr<std::uint64_t[]> bytes; ///< no vector: see EventQueue
    Moment moment;
    std::atomic<Time> until{0}; ///< written also while the moment is read
  };
  static constexpr std::uint8_t place = 3, fresh = 4;

  const Tables& tables_;
  std::array<Buffer, 3> buffers_;
  std::uint64_t shown_ = ~std::uint64_t{
      0}; ///< the micro-step of the last moment; this and the next four are used by the thread that steps
  std::uint64_t passes_ = 0, events_ = 0; ///< before it
  std::uint8_t written_ = 0;
  std::uint8_t newest_ = 0; ///< the buffer that was written last
  std::uint8_t read_ = 1;   ///< used by the thread that shows
  std::atomic<std::uint8_t> between_{2};
  std::atomic<Time> now_{0};
};

} // namespace director::live
