// Header: compiler/analysis/facts/facts.hpp. Test: tests/compiler/analysis/facts/facts_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/facts.hpp"

#include "compiler/analysis/states/region.hpp"

#include <algorithm>

namespace director::analysis {

std::span<const Impossible> Facts::impossible_of(ProviderId provider) const {
  const auto [first, last] =
      std::equal_range(impossible.begin(), impossible.end(), Impossible{provider, false, {}, {}, {}},
                       [](const Impossible& a, const Impossible& b) { return a.provider < b.provider; });
  return {first, last};
}

Region Facts::region_to_begin(const Model& model, ProviderId provider) const {
  Region out = region_of(model, model.providers[provider].when);
  for (const Impossible& fault : impossible_of(provider)) {
    if (!fault.stay) out.states.erase(fault.state);
  }
  return out;
}

Region Facts::region_to_run(const Model& model, ProviderId provider, bool pushed) const {
  Region out = active_region(model, model.providers[provider]);
  for (const Impossible& fault : impossible_of(provider)) out.states.erase(fault.state);
  if (pushed) {
    for (const ConditionUse& promise : model.providers[provider].causing)
      out.states.erase(model.conditions[promise.id].state);
  }
  return out;
}

bool Facts::is_impossible(ProviderId provider, StateId state) const {
  const std::span<const Impossible> faults = impossible_of(provider);
  return std::any_of(faults.begin(), faults.end(),
                     [&](const Impossible& fault) { return !fault.stay && fault.state == state; });
}

bool Facts::may_hold(const Model& model, ProviderId provider, const ConditionUse& use) const {
  const Condition& condition = model.conditions[use.id];
  return is_impossible(provider, condition.state) || values[condition.state].overlaps(condition.accepts);
}

bool Facts::holds_always(const Model& model, ConditionId id, const Region& region) const {
  const Condition& condition = model.conditions[id];
  const auto at = region.states.find(condition.state);
  if (at == region.states.end())
    return !model.states[condition.state].may_be_unset() && values[condition.state].subset_of(condition.accepts);
  return values[condition.state].intersected(at->second).subset_of(condition.accepts);
}

} // namespace director::analysis
