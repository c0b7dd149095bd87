#pragma once
// SPDX-License-Identifier: MIT
// What `why` answers, in words for people, where names are compiled in.

#include "runtime/core/inspect/why.hpp"

namespace director {

/// What rows are called. `self` is given back to each function. For `why` alone the first four are enough.
struct Names {
  const void* self = nullptr;                                                         ///< given to each function
  const char* (*group)(const void* self, Index row) = nullptr;                        ///< `Walk`
  const char* (*provider)(const void* self, Index row) = nullptr;                     ///< without its group
  const char* (*edge)(const void* self, Index row) = nullptr;                         ///< `root>Walk`
  const char* (*condition)(const void* self, Index row) = nullptr;                    ///< `Stability == standing`
  const char* (*state)(const void* self, Index row) = nullptr;                        ///< `Stability`
  const char* (*value)(const void* self, Index state, std::int32_t number) = nullptr; ///< empty for a number of a range
  const char* (*trigger)(const void* self, Index row) = nullptr;                      ///< `Sensors`
  const char* (*level)(const void* self, Index row) = nullptr; ///< empty for the first of a task; may be null
  const Tables* tables = nullptr;                              ///< whose rows they are; only recorders ask
  const char* behaviour = nullptr;                             ///< what it is called; likewise
};

/// One line without an end of line, such as `Kick waits (root>Kick): until Stability == standing, which Walk.halting
/// could cause`. Written into `buffer`, which it returns; cut off where that is too small (at least one byte).
const char* to_text(const Because& because, const Names& names, std::span<char> buffer);

} // namespace director
