#pragma once
// SPDX-License-Identifier: MIT
// Finds the conditions that a task has to wait for without being able to cause them, and the tasks that never run
// because of such a condition. What another finding reports does not count.

#include "compiler/analysis/causing/causing_cycles.hpp"
#include "compiler/analysis/chains/sparse_set.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/input.hpp"
#include "compiler/analysis/requests/gaps.hpp"

#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace director::analysis {

class Unserved {
public:
  explicit Unserved(const Input& input);

  /// Whether the condition is one that a task for this group has to wait for without being able to cause it.
  bool counts(GroupId group, ProviderId provider, const ConditionUse& use) const;
  /// Whether no provider that requests the group runs while the condition holds: once it is caused, the request ends.
  bool ends_requests(GroupId group, const ConditionUse& use) const;
  bool may_cause(GroupId group, ProviderId provider, ProviderId causer) const;
  /// Where a push can lead to the condition, if all that could cause it waits for it, itself or in a cycle.
  const std::optional<std::vector<Region>>& beginnings(GroupId group, ProviderId provider,
                                                       const ConditionUse& use) const;
  /// Adds the ways to run by such a push.
  void add_cycles(GroupId group, std::vector<Region>& ways) const;
  /// Whether none of its providers ever runs, and no finding about one of them reports that.
  bool never_runs(GroupId group) const;
  /// Whether it could run, and all its requests are granted only together with what they exclude, which is reported.
  bool is_in_conflict(GroupId group) const;
  Ways ways_for(GroupId task) const;

private:
  bool may_request_with(ProviderId requester, const ConditionUse& use) const;
  /// Whether all its requests are granted only together with something that never runs and is reported.
  bool waits_with_reported(GroupId group) const;
  bool waits_with_reported(GroupId group, const std::vector<const Task*>& members) const;
  /// Whether another finding reports what prevents it, or what it needs, from running.
  bool is_reported(ProviderId id, SparseSet<GroupId>& seen) const;

  const Model& model_;
  const Facts& facts_;
  const Shared& shared_;
  const CausingCycles cycles_;
  mutable std::map<std::tuple<GroupId, ProviderId, ConditionId>, std::optional<std::vector<Region>>> beginnings_;
  IdSet<ProviderId> explained_;
  std::set<std::pair<GroupId, ConditionId>> pushed_;
  std::set<std::pair<GroupId, ConditionId>> reported_; ///< another finding says why it is not pushed
  std::set<const Task*> conflicting_;                  ///< entries of packs whose members exclude each other
};

} // namespace director::analysis
