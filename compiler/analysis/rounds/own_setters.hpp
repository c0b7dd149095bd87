#pragma once
// SPDX-License-Identifier: MIT
// Finds what may set states while a task runs: the handlers and the providers of the groups that run below it.

#include "compiler/analysis/chains/runs_below.hpp"
#include "compiler/analysis/input.hpp"

#include <functional>
#include <string>

namespace director::analysis {

/// What may set a state.
struct Setter {
  std::string name;
  GroupId group{};
  bool promised = false; ///< it causes it
  bool unpushed = false; ///< also if its own group causes the condition, which is no longer pushed once the task has
                         ///< that group
};

Setter setter_of(const Model& model, ProviderId id);
Setter start_of(const Model& model, GroupId group);

/// Each entry of a group below the task of `waiter`, while that runs: of its start, of its stop if it may stop
/// meanwhile, and of its providers.
void visit_set_below(const Input& input, const RunsBelow& below, GroupId group, ProviderId waiter,
                     const std::function<void(const Setter&, const ConditionUse&)>& visit);

} // namespace director::analysis
