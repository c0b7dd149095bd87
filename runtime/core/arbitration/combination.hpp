#pragma once
// SPDX-License-Identifier: MIT
// The combination of choices in hand: in State::member_*, entry_* and trial, until leave_combination.
// docs/semantics.md, section 4.4, Grant.

#include "runtime/core/arbitration/context.hpp"

namespace director::arbitration {

bool combine(Context& x, Index count, bool with_conditions);
void leave_combination(Context& x, Index count);

} // namespace director::arbitration
