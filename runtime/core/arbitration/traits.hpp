#pragma once
// SPDX-License-Identifier: MIT
// What follows from the tables alone. docs/semantics.md, section 4.

#include "runtime/core/arbitration/context.hpp"

namespace director::arbitration {

void find_traits(Context& x);

} // namespace director::arbitration
