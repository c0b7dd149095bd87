#pragma once
// SPDX-License-Identifier: MIT
// Conditions that never come back once they are lost together, since whatever could bring one of them back runs only
// while one of them holds: a siphon, as it is called of Petri nets. Exact where it says so: what the rest of the
// behaviour does is taken for possible. Only whether they are ever lost at one time is not known.

#include "compiler/analysis/input.hpp"
#include "dsl/diagnostic.hpp"

#include <optional>
#include <vector>

namespace director::analysis {

struct LostForGood {
  GroupId task{}; ///< that waits
  ProviderId waiter{};
  ConditionUse condition{};
  std::vector<ConditionId> lost; ///< that condition, and those that have to be lost with it
  ProviderId causer{};
  /// Of the causer: what it lacks; nothing: a request, or what it needs.
  std::optional<ConditionId> lacking;
  bool unrequested = false;       ///< it lacks a request
  std::vector<dsl::Note> because; ///< who could bring them back, and who makes them false
};

/// In order of task and waiter; each condition of each task once.
std::vector<LostForGood> find_lost_for_good(const Model& model, const Facts& facts, const Shared& shared);

} // namespace director::analysis
