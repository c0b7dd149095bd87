#pragma once
// SPDX-License-Identifier: MIT
// Plans: searched as entries, claimed, and read again as entries. docs/semantics.md, section 4.3.

#include "runtime/core/arbitration/context.hpp"

namespace director::arbitration {

DIRECTOR_PART bool search_plan(Context& x, Index provider, Index begin, Index& end, bool fresh, bool by_declaration);
DIRECTOR_PART bool find_plan(Context& x, Index at, bool first, bool as_it_is, bool with_conditions, bool record);
DIRECTOR_PART bool needs_claimed(const Context& x, Index group);
DIRECTOR_PART void claim_plan(Context& x, Index owner, Index provider, Index begin, Index end);
DIRECTOR_PART Index entries_of(Context& x, Index group, const Assignment& of);

} // namespace director::arbitration
