#pragma once
// SPDX-License-Identifier: MIT
// How a group can be granted to an edge: a provider and a need plan, as a stack of entries; and the combination of choices of
// a unit that is in hand, in State::member_*, entry_* and trial, until leave_combination. docs/semantics.md, sections 4.3 and
// 4.4, Grant.

#include "runtime/core/arbitration/context.hpp"

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
inline bool alternatives(const Context& x, Index component) { return x.t.components[component].alternatives; }

Index preferred(const Context& x, Index group, Index place, Index edge);
bool stays(const Context& x, Index provider);
bool waived(const Context& x, Index provider, Index condition, Index edge);
Index first_false(const Context& x, Index provider, Index edge);
bool next_choice(Context& x, Index at, bool fresh, bool with_conditions, bool record);

bool combine(Context& x, Index count, bool with_conditions);
void leave_combination(Context& x, Index count);

} // namespace director::arbitration
