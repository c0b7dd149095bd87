#pragma once
// SPDX-License-Identifier: MIT
// From what is another than in the last pass to the units that are decided again.
// docs/semantics.md, section 4.4.

#include "runtime/core/arbitration/context.hpp"

namespace director::arbitration {

void rest_on(Context& x, Index edge, std::uint8_t bits);
void begin_followed(Context& x, Index count);
void compare_with_last(Context& x, Index count);
void compare_claim(Context& x, Index group);
void reach_edge(Context& x, Index edge);
void take_up(Context& x, Index edge, bool with_siblings);
void take_up_last(Context& x, Index group);
void reach(Context& x, Index group);
void move(Context& x, Index group);

} // namespace director::arbitration
