#pragma once
// SPDX-License-Identifier: MIT
// Finds what is caused for a task by a group that stops when the task is granted, and whose stop makes the condition
// false again.

#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/rounds/ended_requests.hpp"
#include "compiler/analysis/rounds/settings.hpp"
#include "compiler/analysis/rounds/stopping_groups.hpp"

#include <string>
#include <vector>

namespace director::analysis {

struct StopRound {
  GroupId waits{};     ///< the task that waits for the condition
  std::string granted; ///< is_granted()
  Want want;
  Setting causer;
  StopValue stop;
  ValueSet values; ///< of the stop's, those with which the waiter cannot continue
  Timing timing = Timing::later;
  StopReason reason;
};

/// Not those whose group ends the requests for itself. `stopping`: the groups whose stop may set a state.
std::vector<StopRound> find_stop_rounds(const Input& input, const IdTable<StateId, std::vector<GroupId>>& stopping,
                                        const std::vector<EndedRequests>& ended);

} // namespace director::analysis
