#pragma once
// SPDX-License-Identifier: MIT
// How a group can be granted to an edge. docs/semantics.md, section 4.3.

#include "runtime/core/arbitration/context.hpp"

namespace director::arbitration {

Index preferred(const Context& x, Index group, Index place, Index edge);
bool stays(const Context& x, Index provider);
bool waived(const Context& x, Index provider, Index condition, Index edge);
Index first_false(const Context& x, Index provider, Index edge);
bool next_choice(Context& x, Index at, bool fresh, bool with_conditions, bool record);

} // namespace director::arbitration
