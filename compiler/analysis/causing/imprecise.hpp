#pragma once
// SPDX-License-Identifier: MIT
// Promises that overlap an awaited condition without implying it: they cause no push.

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

/// Of conditions in the `when` of requested groups that nothing else serves; in order of waiter, condition, causer.
std::vector<Imprecise> find_imprecise(const Model& model, const Causers& causers, const Facts& facts);

} // namespace director::analysis
