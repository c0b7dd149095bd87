#pragma once
// SPDX-License-Identifier: MIT
// Finds the conditions that tasks wait for, and the providers that they may push for them (semantics.md 4.4, "Refuse").

#include "compiler/analysis/chains/meetings.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/facts/pushes.hpp"

#include <vector>

namespace director::analysis {

/// A condition that may be false although some provider could be pushed for it.
struct Want {
  ProviderId waiter{}; ///< the provider of the task, or one that its needs may lead to
  ConditionUse condition{};
  std::vector<ProviderId> causers; ///< of other groups, in order; never empty
};

/// The conditions that one provider of a requested group may wait for, by itself and by its needs.
struct Wanting {
  GroupId task{};
  ProviderId provider{};
  std::vector<Want> wants; ///< never empty
};

/// In order of task and provider. `chains`: over the providers that may be active.
std::vector<Wanting> find_wants(const Model& model, const Facts& facts, const Chains& chains, const Causers& causers);

} // namespace director::analysis
