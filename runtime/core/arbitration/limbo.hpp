#pragma once
// SPDX-License-Identifier: MIT
// Groups that are kept alive for an heir. docs/semantics.md, section 4.4, Hand-over.

#include "runtime/core/arbitration/context.hpp"

namespace director::arbitration {

void keep_for_heirs(Context& x);

} // namespace director::arbitration
