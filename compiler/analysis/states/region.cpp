// Header: compiler/analysis/states/region.hpp. Test: tests/compiler/analysis/states/region_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/states/region.hpp"

#include <algorithm>

namespace director::analysis {

bool Region::empty() const {
  return std::any_of(states.begin(), states.end(), [](const auto& entry) { return entry.second.empty(); });
}

void Region::meet(StateId state, const ValueSet& values) {
  const auto [at, is_new] = states.try_emplace(state, values);
  if (!is_new) at->second = at->second.intersected(values);
}

void Region::meet(const Region& other) {
  for (const auto& [state, values] : other.states) meet(state, values);
}

Region region_of(const Model& model, const std::vector<ConditionUse>& conditions) {
  Region out;
  for (const ConditionUse& use : conditions) out.meet(model.conditions[use.id].state, model.conditions[use.id].accepts);
  return out;
}

Region hull(const Region& a, const Region& b) {
  Region out;
  for (const auto& [state, values] : a.states) {
    const auto at = b.states.find(state);
    if (at != b.states.end()) out.states.emplace(state, values.united(at->second));
  }
  return out;
}

Region active_region(const Model& model, const Provider& provider) {
  const Region when = region_of(model, provider.when);
  return provider.stay.empty() ? when : hull(when, region_of(model, provider.stay));
}

bool contains(const Region& outer, const Region& inner) {
  return std::all_of(outer.states.begin(), outer.states.end(), [&](const auto& entry) {
    const auto at = inner.states.find(entry.first);
    return at != inner.states.end() && at->second.subset_of(entry.second);
  });
}

bool compatible(const Region& a, const Region& b) {
  return std::all_of(a.states.begin(), a.states.end(), [&](const auto& entry) {
    const auto at = b.states.find(entry.first);
    return at == b.states.end() || entry.second.overlaps(at->second);
  });
}

} // namespace director::analysis
