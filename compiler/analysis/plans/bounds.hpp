#pragma once
// SPDX-License-Identifier: MIT
// Bounds on the cost of the engine, from the specification alone. docs/bounds.md defines each one and proves it.

#include "compiler/model/model.hpp"
#include "runtime/core/base/tables.hpp"

namespace director::analysis {

using namespace director::compiler;

struct Bounds {
  std::int64_t decision_bytes = 0;       ///< RAM of the decision state
  std::int64_t engine_bytes = 0;         ///< that, and the scratch memory of a pass
  std::int64_t runs_waiting = 0;         ///< entries of the run queue
  std::int64_t trials = 0;               ///< combinations of providers and plans that one decision tries
  std::int64_t trials_in_a_pass = 0;     ///< the same, for all that one pass over one component decides
  std::int64_t work_in_a_pass = 0;       ///< units of Engine::work, repetitions of the pass among them
  std::int64_t work_in_a_micro_step = 0; ///< the same, for all that one micro-step decides
  std::int64_t repetitions = 0;          ///< repetitions of the pass after one micro-step
  std::int64_t to_first_run = 0;         ///< micro-steps from a root request that is granted at once to its run
  std::int64_t calm_input = 0;           ///< micro-steps for an input that changes no decision, if bodies answer keep
  bool counted = true;                   ///< false: there are more combinations than `trials`, too many to count
  bool handlers_set = false;             ///< some handler sets a state, or a state belongs to a group: one input each
  bool operator==(const Bounds&) const = default;
};

/// `tables` are of the model.
Bounds find_bounds(const Model& model, const Tables& tables);

} // namespace director::analysis
