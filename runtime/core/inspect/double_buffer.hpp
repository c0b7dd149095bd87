#pragma once
// SPDX-License-Identifier: MIT
// Two buffers between one writer and any number of readers, in any threads: the writer fills one while readers may be
// in the other. No thread waits: readers only enter the buffer that was finished last, so the other one becomes empty
// by itself. Needs the same atomics as the inbox.

#include "runtime/core/base/tables.hpp"

#include <atomic>

namespace director {

class DoubleBuffer {
public:
  // For the writer.

  /// A buffer to write into; nil: a reader is still in the older one, and nothing can be written this time.
  Index begin() const {
    const std::uint32_t now = state_.load(std::memory_order_acquire);
    const Index spare = last(now) == 1 ? 1 : 0;
    return readers(now, spare) == 0 ? spare : nil;
  }
  /// Makes readers enter this buffer from now on.
  void finish(Index buffer) {
    std::uint32_t now = state_.load(std::memory_order_relaxed);
    while (!replace(now, (now & ~3U) | (buffer + 1U))) {}
  }

  // For readers.

  /// Enters the buffer that was finished last; nil: there is none, or 255 readers are in it.
  Index enter() {
    std::uint32_t now = state_.load(std::memory_order_relaxed);
    while (last(now) != 0) {
      const auto buffer = static_cast<Index>(last(now) - 1);
      if (readers(now, buffer) == 0xFF) break;
      if (replace(now, now + one_reader(buffer))) return buffer;
    }
    return nil;
  }
  void leave(Index buffer) {
    std::uint32_t now = state_.load(std::memory_order_relaxed);
    while (!replace(now, now - one_reader(buffer))) {}
  }

private:
  static std::uint32_t last(std::uint32_t state) { return state & 3U; }
  static std::uint32_t one_reader(Index buffer) { return 0x100U << (8 * buffer); }
  static std::uint32_t readers(std::uint32_t state, Index buffer) { return state >> (8 + 8 * buffer) & 0xFFU; }
  bool replace(std::uint32_t& now, std::uint32_t next) {
    return state_.compare_exchange_weak(now, next, std::memory_order_acq_rel, std::memory_order_relaxed);
  }

  /// Bits 0-1: 0, or one more than the buffer to enter; then a byte for the number of readers of each buffer.
  std::atomic<std::uint32_t> state_{0};
};

} // namespace director
