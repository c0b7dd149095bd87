#pragma once
// SPDX-License-Identifier: MIT
// The word of states that each slot of OverflowSlots has: two bits for each of its places. Only its own files include
// this.

#include "runtime/core/engine/overflow_slots.hpp"

namespace director {

enum class PlaceState : std::uint32_t { free = 0, filling = 1, published = 2, held = 3 };

constexpr std::uint32_t bits_each = 2;

constexpr PlaceState state_of(std::uint32_t states, Index place) {
  return static_cast<PlaceState>(states >> (bits_each * place) & 3U);
}

constexpr std::uint32_t with(std::uint32_t states, Index place, PlaceState state) {
  const std::uint32_t shift = bits_each * place;
  return (states & ~(3U << shift)) | static_cast<std::uint32_t>(state) << shift;
}

constexpr Index find(std::uint32_t states, PlaceState state) {
  for (Index place = 0; place < OverflowSlots::places; ++place) {
    if (state_of(states, place) == state) return place;
  }
  return nil;
}

constexpr bool any_published(std::uint32_t states) { return (states >> 1 & ~states & 0x55U) != 0; }

/// Is `a` before `b`? Both count round and round, and are never far apart.
constexpr bool precedes(std::uint32_t a, std::uint32_t b) { return static_cast<std::int32_t>(a - b) < 0; }

/// Replaces the states by what `next` makes of them, in one step.
template <class Next>
std::uint32_t change(std::atomic<std::uint32_t>& states, Next next) {
  std::uint32_t now = states.load(std::memory_order_acquire);
  while (!states.compare_exchange_weak(now, next(now), std::memory_order_acq_rel, std::memory_order_acquire)) {}
  return now;
}

/// One more; what it was before.
inline std::uint32_t count(std::atomic<std::uint32_t>& number) {
  return change(number, [](std::uint32_t now) { return now + 1; });
}

} // namespace director
