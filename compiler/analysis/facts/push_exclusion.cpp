// Header: compiler/analysis/facts/push_exclusion.hpp. Test: tests/compiler/analysis/facts/push_exclusion_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/push_exclusion.hpp"

#include "compiler/analysis/chains/sparse_set.hpp"

#include <algorithm>
#include <iterator>

namespace director::analysis {

namespace {

/// Limit for the needed groups whose conditions count.
constexpr std::size_t most_needed = 16;

/// The first of the states of which the two leave no value in common. `among`: only these; null: all.
std::optional<StateId> find_different(const Region& a, const Region& b, const IdSet<StateId>* among) {
  for (const auto& [state, values] : a.states) {
    if (among != nullptr && !among->contains(state)) continue;
    const auto at = b.states.find(state);
    if (at != b.states.end() && !values.overlaps(at->second)) return state;
  }
  return std::nullopt;
}

} // namespace

PushExclusion::PushExclusion(const Model& model, const Facts& facts, const Causers& causers)
    : model_(model),
      facts_(facts),
      causers_(causers),
      outside_(model.states.size()),
      waiting_(model.providers.size()),
      chosen_(model.providers.size()) {
  IdSet<StateId> inside(model.states.size());
  const auto add = [&](const std::vector<ConditionUse>& entries) {
    for (const ConditionUse& entry : entries) inside.add(model.conditions[entry.id].state);
  };
  for (const Provider& provider : model.providers) {
    add(provider.sets);
    add(provider.causing);
  }
  for (const Group& group : model.groups) {
    if (group.start) add(group.start->sets);
    if (group.stop) add(group.stop->sets);
  }
  for (const StateId state : model.states.ids()) {
    if (model.states[state].external && !inside.contains(state)) outside_.add(state);
  }
}

std::optional<StateId> PushExclusion::find(ProviderId waiter, ProviderId causer) const {
  return find_different(region(waiter, true), region(causer, false), nullptr);
}

std::optional<StateId> PushExclusion::find_outside(ProviderId waiter, ProviderId causer) const {
  return find_different(region(waiter, true), region(causer, false), &outside_);
}

std::optional<StateId> PushExclusion::find_outside(ProviderId waiter, const Region& waiting, ProviderId causer,
                                                   const Region& requested) const {
  Region here = region(waiter, true), there = region(causer, false);
  here.meet(waiting);
  there.meet(requested);
  return find_different(here, there, &outside_);
}

std::optional<StateId> PushExclusion::find_beside(ProviderId chosen, ProviderId causer) const {
  return find_different(region(chosen, false), region(causer, false), nullptr);
}

std::vector<std::pair<ProviderId, ConditionUse>> PushExclusion::conditions_on(StateId state,
                                                                              ProviderId provider) const {
  std::vector<ProviderId> all = needed(provider);
  all.insert(all.begin(), provider);
  std::vector<std::pair<ProviderId, ConditionUse>> out;
  for (const ProviderId id : all) {
    for (const ConditionUse& use : model_.providers[id].when) {
      if (model_.conditions[use.id].state == state && causers_[use.id].empty()) out.emplace_back(id, use);
    }
  }
  return out;
}

ValueSet PushExclusion::values_of(StateId state, ProviderId provider, const Region& region) const {
  ValueSet out = facts_.values[state];
  if (const auto at = region.states.find(state); at != region.states.end()) out = out.intersected(at->second);
  for (const auto& [id, use] : conditions_on(state, provider)) out = out.intersected(model_.conditions[use.id].accepts);
  return out;
}

const Region& PushExclusion::region(ProviderId id, bool waits) const {
  std::optional<Region>& known = (waits ? waiting_ : chosen_)[id];
  if (known) return *known;
  Region out = own(id, waits);
  for (const ProviderId each : needed(id)) out.meet(own(each, false));
  return known.emplace(std::move(out));
}

/// While it waits its `stay` does not hold, and nothing is missing from its `when` that cannot be caused. Otherwise its
/// `stay` may hold instead. What it causes itself does not count while it is pushed.
Region PushExclusion::own(ProviderId id, bool waits) const {
  const Provider& provider = model_.providers[id];
  std::vector<ConditionUse> lasting;
  std::copy_if(provider.when.begin(), provider.when.end(), std::back_inserter(lasting), [&](const ConditionUse& use) {
    return causers_[use.id].empty() && !facts_.is_impossible(id, model_.conditions[use.id].state);
  });
  Region out = region_of(model_, lasting);
  for (const ConditionUse& promise : provider.causing) out.states.erase(model_.conditions[promise.id].state);
  return waits || provider.stay.empty() ? out : hull(out, region_of(model_, provider.stay));
}

std::vector<ProviderId> PushExclusion::needed(ProviderId id) const {
  std::vector<ProviderId> out;
  if (facts_.plans[id] != PlanVerdict::found) return out;
  SparseSet<GroupId> seen;
  std::vector<ProviderId> open{id};
  while (!open.empty() && out.size() < most_needed) {
    const ProviderId at = open.back();
    open.pop_back();
    for (const Use<GroupId>& need : model_.providers[at].needs) {
      const std::vector<ProviderId>& all = model_.groups[need.id].providers;
      if (all.size() != 1 || !seen.add(need.id)) continue;
      out.push_back(all.front());
      open.push_back(all.front());
    }
  }
  return out;
}

} // namespace director::analysis
