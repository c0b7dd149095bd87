#pragma once
// SPDX-License-Identifier: MIT
// How much work (Engine::work: groups placed, units decided, choices and plans tried) a pass and a micro-step take at
// most. Follows what runtime/core/arbitration does, function by function, and never what it does well.

#include "compiler/analysis/plans/trials.hpp"
#include "runtime/core/base/tables.hpp"

namespace director::analysis {

/// What a unit of work is taken to cost where nobody says what it costs on his machine: the dearest of the behaviours
/// for which ./bench measures it, rounded up. docs/performance.md, "dearest micro-step", has the machine and the
/// numbers.
inline constexpr double nanoseconds_of_work = 150;

struct WorkBound {
  std::int64_t pass = 0;       ///< of one pass, with its repetitions, over the component that takes the most
  std::int64_t micro_step = 0; ///< an input may reach all components
  bool counted = true;         ///< false: there are more plans than were counted
};

/// `tables` are of the model.
WorkBound bound_work(const Model& model, const Tables& tables, Trials& trials);

} // namespace director::analysis
