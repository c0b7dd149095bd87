#pragma once
// SPDX-License-Identifier: MIT
// Bounds the work (Engine::work: groups placed, units decided, choices and plans tried) of a pass and a micro-step.
// Mirrors runtime/core/arbitration function by function, without its optimisations.

#include "compiler/analysis/plans/trials.hpp"
#include "runtime/core/base/tables.hpp"

namespace director::analysis {

/// The default cost of a unit of work, for a machine without a measurement: the highest of the behaviours in ./bench,
/// rounded up. docs/performance.md, "dearest micro-step", has the machine and the numbers.
inline constexpr double nanoseconds_of_work = 150;

struct WorkBound {
  std::int64_t pass = 0;       ///< of one pass, with its repetitions, over the component that takes the most
  std::int64_t micro_step = 0; ///< an input may reach all components
  bool counted = true;         ///< false: there are more plans than were counted
};

/// `tables` are of the model.
WorkBound bound_work(const Model& model, const Tables& tables, Trials& trials);

} // namespace director::analysis
