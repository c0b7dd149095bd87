#pragma once
// SPDX-License-Identifier: MIT
// Compares the order of tasks of equal rank: with equal rank the earlier request goes first, and of those that are
// requested at once the one that is declared first (semantics.md, 4.1, rule 5).

#include "compiler/diff/side.hpp"
#include "compiler/diff/ranks/takes_by_name.hpp"

namespace director::compiler::diff {

/// Reports the order only where it decides which task gets a group, or what is pushed.
void compare_ties(const Pair& pair, const TakesByName& before, const TakesByName& after, Changes& changes);

} // namespace director::compiler::diff
