#pragma once
// SPDX-License-Identifier: MIT
// The value of a group's state (`of`) while the group does not run.

#include "compiler/analysis/states/covering.hpp"
#include "compiler/model/model.hpp"

namespace director::analysis {

/// The initial value, what the group's stop handler may have set, and what that expires to. The state must have an
/// `of`.
Possible values_while_stopped(const Model& model, const State& state);

/// A condition of the provider on a state of its own group, with a value that the state loses when the group stops;
/// null: none.
const ConditionUse* find_own_step(const Model& model, ProviderId id);

} // namespace director::analysis
