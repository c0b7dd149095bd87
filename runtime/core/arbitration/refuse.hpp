#pragma once
// SPDX-License-Identifier: MIT
// What becomes of a unit that does not. docs/semantics.md, section 4.4, Refuse.

#include "runtime/core/arbitration/context.hpp"

namespace director::arbitration {

void block(Context& x, Index count);
void block_alone(Context& x, Index edge);
void refuse(Context& x, Index count);
void explain(Context& x, Index count, Why why, Index condition = nil);

} // namespace director::arbitration
