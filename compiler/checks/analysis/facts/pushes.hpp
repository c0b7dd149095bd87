#pragma once
// Which causing providers may be pushed, given what is known to be possible so far (semantics.md 4.4, "Refuse").

#include "compiler/checks/analysis/chains/meetings.hpp"
#include "compiler/checks/analysis/chains/sparse_set.hpp"
#include "compiler/checks/analysis/facts/facts.hpp"

namespace director::checks {

/// For each condition the providers that cause it, in order.
using Causers = IdTable<ConditionId, std::vector<ProviderId>>;
Causers find_causers(const Model& model);

/// The causing providers that a task for one group may push, and what keeps it from pushing.
struct PushGoals {
  SparseSet<GroupId> beaten;        ///< groups of causing providers that it may go before
  SparseSet<ConditionId> servable;  ///< conditions that may hold, or that a chain of pushes may bring about
  std::vector<ProviderId> pushable; ///< in order of id
};

/// `waiter` is a requested group. `requested` and the values are those of `facts` so far.
PushGoals find_push_goals(const Model& model, const Facts& facts, const Chains& chains, const Causers& causers,
                          GroupId waiter);

/// What a task for this group may wait for: the conditions of its providers and of those in their plans.
std::vector<std::pair<ProviderId, ConditionUse>> waited_conditions(const Model& model, const Facts& facts,
                                                                   GroupId waiter);

} // namespace director::checks
