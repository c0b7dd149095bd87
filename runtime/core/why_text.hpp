#pragma once
// What `why` answers, in words for people, where names are compiled in.

#include "runtime/core/why.hpp"

namespace director {

/// What rows are called: the functions that generated code has in its namespace `names`.
struct Names {
  const char* (*group)(Index row) = nullptr;
  const char* (*provider)(Index row) = nullptr; ///< without its group
  const char* (*edge)(Index row) = nullptr;     ///< `root>Walk`
  const char* (*condition)(Index row) = nullptr;
};

/// One line without an end of line, such as `Kick waits (root>Kick): until Stability == standing, which Walk.halting
/// could cause`. Written into `room`, which it returns; cut off where that is too small (at least one byte).
const char* to_text(const Because& because, const Names& names, std::span<char> room);

} // namespace director
