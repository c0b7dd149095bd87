#pragma once
// SPDX-License-Identifier: MIT
// Explains why a group that was requested stops when a task is granted.

#include "compiler/analysis/input.hpp"
#include "compiler/analysis/rounds/granted.hpp"

#include <optional>

namespace director::analysis {

struct StopReason {
  Taking how;
  const Task* refused = nullptr; ///< the only request that is blocked although its requester goes on
};

/// Because of what the task takes from it, or from all that request it, described for the first of them. Empty: the
/// group continues, or is handed over, or it is not certain. `causer`: the provider whose need is described first.
std::optional<StopReason> why_stopped(const Input& input, const Granted& granted, GroupId group, ProviderId causer);

} // namespace director::analysis
