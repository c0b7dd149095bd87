#pragma once
// SPDX-License-Identifier: MIT
// What stands below the answer of `why`: who is in the way and for whom, what the state is worth that is missing, and
// what becomes of each who could cause it.

#include "runtime/core/inspect/why.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace director {

struct WhyNote {
  /// What `row` is one of. Of a condition: it is missing, and the note says what its state is worth.
  enum class About : std::uint8_t { edge, condition, state, provider };
  std::string text;
  About about = About::edge;
  Index row = nil;
  bool operator==(const WhyNote&) const = default;
};

/// `because`: what `why` answered about this view.
std::vector<WhyNote> why_notes(const View& view, const Because& because, const Names& names);

/// What is in the way is held: `because.group`, by the edge `because.holder`.
inline bool is_blocked(const Because& because) {
  return because.kind == Because::Kind::lost || because.kind == Because::Kind::need_held;
}

/// As it is written: `lost`, `need_held`.
std::string_view name_of(Because::Kind kind);

} // namespace director
