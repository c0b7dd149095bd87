#pragma once
// SPDX-License-Identifier: MIT
// The units that a change reaches, so that this pass decides them again. docs/semantics.md, section 4.4.

#include "runtime/core/arbitration/context.hpp"

namespace director::arbitration {

DIRECTOR_PART void check_lines(Context& x, Index group);
DIRECTOR_PART void note_dependence(Context& x, Index edge, std::uint8_t bits);
DIRECTOR_PART void begin_followed(Context& x, Index count);
DIRECTOR_PART void compare_with_last(Context& x, Index count);
DIRECTOR_PART void reach_edge(Context& x, Index edge);
void reach_by_request(Context& x, Index edge, bool with_siblings);
void reach_by_last_result(Context& x, Index group);
DIRECTOR_PART void reach_users(Context& x, Index group);
DIRECTOR_PART void reach_all_below(Context& x, Index group);

/// Makes this pass decide again the units whose decision may depend on the group.
inline void reach(Context& x, Index group) {
  if (!x.whole) reach_users(x, group);
}

/// Reaches all below the group if its claim differs. A need is claimed with the group that has it, a request in turn.
inline void compare_claim(Context& x, Index group) {
  const GroupAssignment &now = x.s.now[group], &last = x.s.last[group];
  if (!x.whole && (now.holder != last.holder || now.needed() != last.needed())) reach_all_below(x, group);
}

} // namespace director::arbitration
