#pragma once
// SPDX-License-Identifier: MIT
// Need plans, as stacks of entries. docs/semantics.md, section 4.3.

#include "runtime/core/arbitration/context.hpp"
#include "runtime/core/base/marks.hpp"

namespace director::arbitration {

Index slot_of(const Context& x, Index owner, Index group);
void drop_entries(Context& x, Index begin, Index end);
bool search_plan(Context& x, Index provider, Index begin, Index& end, bool fresh, bool by_declaration);
void plan_for(Context& x, Index owner, Index provider, Index begin, Index end);
void claim_plan(Context& x, Index begin, Index end);
Index entries_of(Context& x, Index group, const Assignment& of);

/// Where the entries of a member's plan begin.
inline Index entries_begin(const Context& x, Index at) { return at == 0 ? Index{0} : x.s.member_entries[at - 1]; }

/// A plan of some group may pick one provider or another.
inline bool alternatives(const Context& x, Index component) {
  return (x.s.component_traits[component] & trait::alternatives) != 0;
}

} // namespace director::arbitration
