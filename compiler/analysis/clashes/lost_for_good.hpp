#pragma once
// SPDX-License-Identifier: MIT
// Finds conditions that never become true again once they are lost together, since everything that could cause one of
// them runs only while one of them holds: a siphon, in terms of Petri nets. Exact in what it reports: all other effects
// are assumed possible. Unknown is only whether the conditions are ever lost together.

#include "compiler/analysis/input.hpp"
#include "dsl/source/diagnostic.hpp"

#include <optional>
#include <vector>

namespace director::analysis {

struct LostForGood {
  GroupId task{}; ///< that waits
  ProviderId waiter{};
  ConditionUse condition{};
  std::vector<ConditionId> lost; ///< that condition, and those that have to be lost with it
  ProviderId causer{};
  /// Of the causer: the condition that it lacks; empty: a request, or a need.
  std::optional<ConditionId> lacking;
  bool unrequested = false;       ///< it lacks a request
  std::vector<dsl::Note> because; ///< what could cause them, and what makes them false
};

/// In order of task and waiter; each condition of each task once.
std::vector<LostForGood> find_lost_for_good(const Model& model, const Facts& facts, const Shared& shared);

} // namespace director::analysis
