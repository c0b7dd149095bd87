#pragma once
// SPDX-License-Identifier: MIT
// Finds groups that end all requests for themselves by what they set, while the value that their stop sets lets one of
// the requesters begin again.

#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/input.hpp"

#include <optional>
#include <vector>

namespace director::analysis {

struct EndedRequests {
  GroupId group{};
  StateId state{};
  ProviderId setter{}; ///< a provider of the group
  ConditionUse entry{};
  bool promised = false; ///< the entry is one of its `causing`; else of its `sets`
  StopValue stop;
  ProviderId requester{};           ///< the first one that begins again
  ProviderId waits{};               ///< it, or one that it needs, which cannot run with what is set
  std::optional<ProviderId> next{}; ///< another provider of the requester's group that may run then
};

/// One for each group and state. `stopping`: the groups whose stop may set a state.
std::vector<EndedRequests> find_ended_requests(const Input& input,
                                               const IdTable<StateId, std::vector<GroupId>>& stopping);

} // namespace director::analysis
