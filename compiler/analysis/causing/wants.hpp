#pragma once
// SPDX-License-Identifier: MIT
// Finds the conditions that tasks wait for, and the providers that they may push for them (semantics.md 4.4, "Refuse").

#include "compiler/analysis/chains/meetings.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/facts/pushes.hpp"
#include "compiler/analysis/plans/plans.hpp"

#include <optional>
#include <vector>

namespace director::analysis {

/// Why a provider is pushed.
struct Pushed {
  GroupId by{};         ///< the task that pushes it
  ConditionId wanted{}; ///< what that one, or another provider that it pushes, waits for
};

/// A condition that may be false although some provider could be pushed for it.
struct Want {
  ProviderId waiter{}; ///< the provider of the task, or one that its needs may lead to
  ConditionUse condition{};
  std::vector<ProviderId> causers; ///< of other groups, in order; never empty
  std::optional<Pushed> pushed{};  ///< the waiter is not what waits itself, but pushed for this
};

/// The conditions that one provider of a requested group may wait for, by itself and by its needs.
struct Wanting {
  GroupId task{};
  ProviderId provider{};
  std::vector<Want> wants; ///< never empty
};

/// In order of task and provider. `chains`: over the providers that may be active.
std::vector<Wanting> find_wants(const Model& model, const Facts& facts, const Chains& chains, const Causers& causers);

/// The conditions of the providers that these tasks push, which have to be caused first: a chain of pushes. Each
/// provider once, as pushed by the first task that does; in order of provider. Not what another provider of its group
/// keeps from running meanwhile.
std::vector<Wanting> find_wants_of_pushed(const Model& model, const Facts& facts, const Chains& chains,
                                          const Causers& causers, const Indispensable& indispensable,
                                          const std::vector<Wanting>& wants);

} // namespace director::analysis
