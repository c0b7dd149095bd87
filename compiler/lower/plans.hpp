#pragma once
// SPDX-License-Identifier: MIT
// Finds the providers that may be in a plan of a provider. Source: semantics.md, section 1 (need plans).

#include "compiler/model/model.hpp"

#include <cstddef>
#include <vector>

namespace director::compiler {

/// Enough for real behaviours: a provider with eight needs of three alternatives each has 6,561 plans, and the first
/// few of them answer most queries.
inline constexpr std::size_t most_plan_steps = 10'000;

struct PlanProviders {
  std::vector<ProviderId> providers; ///< ascending, without the provider itself
  bool exact = true;                 ///< false: the search reached its limit, and these are all that could be in a plan
};

/// The providers that occur in at least one valid plan of this one.
PlanProviders providers_in_plans(const Model& model, ProviderId provider, std::size_t most_steps = most_plan_steps);

} // namespace director::compiler
