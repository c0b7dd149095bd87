#pragma once
// SPDX-License-Identifier: MIT
// The pass of docs/semantics.md, section 4.4, is greedy along the order of edges: the first candidate takes what it
// needs, and nobody behind it can change that. So one sweep decides, and only the rule that equals never take from each
// other can ask for a repetition. A sweep goes along the order as the last one did and decides a unit again only where
// something reaches it that is another than last time (reach.cpp); groups that hold nothing of that are passed by, each
// with all below it (trail.hpp). What comes out equals the pass from nothing. Cost: some work for each edge of root and
// for each edge of a group that is looked at, and for each unit reached providers and plans tried, each compared along
// its chain of holders.
//
// While it decides, a pass notes what its result may depend on besides requests, values and flags: on the assignment
// before (then it has to be repeated on its own result), and on whose orders are outdated (then again when that
// changes). Where neither is so, nothing has to be decided until an input of the component changes.

#include "runtime/core/arbitration/context.hpp"
#include "runtime/core/base/parts.hpp"

namespace director::arbitration {

/// Reads State's decision part; writes `now`, `next_order`, `next_count` and `queued` of the component.
void decide(Context& x, Index component);

/// Of a pass that is about to sweep, or has swept in vain: it sweeps from the beginning.
void begin(Context& x);

/// When the engine has compared the result with the last one: notes for the next pass what this one found.
void end(Context& x);

/// Live groups that nobody claims are kept for an heir that is about to run.
DIRECTOR_PART void keep_for_heirs(Context& x);

/// The next pass over each component begins from nothing: the last assignment is not that of its last pass.
void forget_trail(Context& x);

} // namespace director::arbitration
