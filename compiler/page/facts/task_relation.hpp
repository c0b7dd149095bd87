#pragma once
// SPDX-License-Identifier: MIT
// Finds how two tasks of one requester relate: whether it ever requests both at once, as one unit, or needs one of
// them.

#include "compiler/analysis/ranks/contention.hpp"
#include "compiler/model/model.hpp"

namespace director::compiler {

/// Of the two edges of a decision.
struct TaskRelation {
  bool at_once = false;                             ///< some pack, with the needs of its provider, has both
  bool unit = false;                                ///< granted together, or not at all
  bool first_loose = false, second_loose = false;   ///< both are requested by some pack, and this one is neither in one
                                                    ///< unit with the other one nor a need
  bool first_needed = false, second_needed = false; ///< by a provider while the other one is requested, or that needs
                                                    ///< it too
  bool first_alone = false, second_alone = false;   ///< likewise, and does not need the other one
  bool first_own = false, second_own = false; ///< needed, and that provider requests the other one, or needs it too
};

TaskRelation relation_of(const Model& model, const analysis::Decision& decision);

} // namespace director::compiler
