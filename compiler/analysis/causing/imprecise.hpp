#pragma once
// SPDX-License-Identifier: MIT
// Promises that overlap an awaited condition without implying it: they cause no push.

#include "compiler/analysis/chains/meetings.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/facts/pushes.hpp"

#include <vector>

namespace director::analysis {

struct Imprecise {
  ProviderId waiter{};
  ConditionUse condition{};
  ProviderId causer{};
  ConditionUse promise{};
};

/// Of conditions that nothing else serves, and that some task waits for which goes before the promising group; in order
/// of waiter, condition, causer.
std::vector<Imprecise> find_imprecise(const Model& model, const Causers& causers, const Facts& facts,
                                      const Chains& chains);

} // namespace director::analysis
