#pragma once
// SPDX-License-Identifier: MIT
// Hints for the processor: what is about to be looked at. In a behaviour with thousands of groups it lies far away in
// memory; what is asked for at once arrives side by side, and not one thing after the other. Nothing depends on it.

#include <cstddef>
#include <cstdint>

namespace director {

inline constexpr std::size_t line_of_cache = 64; ///< bytes; of others than most processors it is still a hint

/// The line of the cache in which the row stands, so many before it and so many behind it, whatever lies there.
template <class T>
[[gnu::always_inline]] inline void fetch(const T* row, int before = 0, int behind = 0) {
  const auto at = reinterpret_cast<std::uintptr_t>(row);
  for (int i = -before; i <= behind; ++i)
    __builtin_prefetch(reinterpret_cast<const void*>(at + static_cast<std::uintptr_t>(i) * line_of_cache));
}

} // namespace director
