#pragma once
// SPDX-License-Identifier: MIT
// Whether a group that was requested goes on when a task is granted, and why it stops.

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

/// Whether something that requests the group goes on, and with it this request. Another provider may keep the requests
/// of the one that it replaces.
bool stays_requested(const Input& input, const Granted& granted, GroupId group);

} // namespace director::analysis
