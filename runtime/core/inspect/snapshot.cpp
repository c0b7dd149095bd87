// docs/semantics.md, section 2, as other threads may see it.
// SPDX-License-Identifier: MIT
//
// Readers only ever enter the buffer that was finished last, so the other one becomes empty by itself.

#include "runtime/core/inspect/snapshot.hpp"

namespace director {

namespace {

constexpr std::uint32_t one_reader(Index buffer) { return 0x100U << (8 * buffer); }
constexpr std::uint32_t readers(std::uint32_t state, Index buffer) { return state >> (8 + 8 * buffer) & 0xFFU; }
constexpr std::uint32_t last(std::uint32_t state) { return state & 3U; }
constexpr std::uint32_t with_last(std::uint32_t state, Index buffer) { return (state & ~3U) | (buffer + 1U); }

} // namespace

Index DoubleBuffer::begin() {
  const std::uint32_t now = state_.load(std::memory_order_acquire);
  const Index spare = last(now) == 1 ? 1 : 0;
  return readers(now, spare) == 0 ? spare : nil;
}

void DoubleBuffer::finish(Index buffer) {
  std::uint32_t now = state_.load(std::memory_order_relaxed);
  while (!state_.compare_exchange_weak(now, with_last(now, buffer), std::memory_order_acq_rel,
                                       std::memory_order_relaxed)) {}
}

Index DoubleBuffer::enter() {
  std::uint32_t now = state_.load(std::memory_order_relaxed);
  for (;;) {
    if (last(now) == 0) return nil;
    const auto buffer = static_cast<Index>(last(now) - 1);
    if (readers(now, buffer) == 0xFF) return nil;
    if (state_.compare_exchange_weak(now, now + one_reader(buffer), std::memory_order_acquire,
                                     std::memory_order_relaxed))
      return buffer;
  }
}

void DoubleBuffer::leave(Index buffer) {
  std::uint32_t now = state_.load(std::memory_order_relaxed);
  while (!state_.compare_exchange_weak(now, now - one_reader(buffer), std::memory_order_release,
                                       std::memory_order_relaxed)) {}
}

} // namespace director
