#pragma once
// SPDX-License-Identifier: MIT
// The notes below the answer of `why`: what holds or lacks what, each at its edge, condition, state or provider.

#include "runtime/core/inspect/why.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace director {

struct WhyNote {
  /// The table of `row`. A condition is false, and the note has the value of its state.
  enum class About : std::uint8_t { edge, condition, state, provider };
  std::string text;
  About about = About::edge;
  Index row = nil;
  bool operator==(const WhyNote&) const = default;
};

/// `because`: the answer of `why` for this view.
std::vector<WhyNote> why_notes(const View& view, const Because& because, const Names& names);

/// Whether the group in the way, `because.group`, is held, by the edge `because.holder`.
inline bool is_blocked(const Because& because) {
  return because.kind == Because::Kind::lost || because.kind == Because::Kind::need_held;
}

/// The text of a kind: `lost`, `need_held`.
std::string_view name_of(Because::Kind kind);

} // namespace director
