// Header: compiler/analysis/requests/standstill.hpp. Test: compiler/checks/causer_not_running.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/requests/standstill.hpp"

#include "compiler/analysis/states/stopped_values.hpp"

#include <algorithm>

namespace director::analysis {

bool Standstill::may_wait(const Request& request, ProviderId waiter, const ConditionUse& use,
                          const std::vector<GroupId>& absent) {
  const std::vector<Region> regions = requests_.regions(request);
  return std::any_of(regions.begin(), regions.end(),
                     [&](const Region& region) { return may_wait(region, waiter, use, absent); });
}

bool Standstill::may_wait(const Region& region, ProviderId waiter, const ConditionUse& use,
                          const std::vector<GroupId>& absent) {
  const Condition& condition = model_.conditions[use.id];
  Box start = box_of(facts_.values, region);
  Possible& here = possible_in(model_, facts_, condition.state, start);
  const State& state = model_.states[condition.state];
  if (state.of && std::find(absent.begin(), absent.end(), state.of->id) != absent.end()) {
    const Possible at_rest = values_while_stopped(model_, state);
    here = {here.values.intersected(at_rest.values), here.unset && at_rest.unset};
  }
  here.values = here.values.without(condition.accepts);
  for (const ConditionUse& other : model_.providers[waiter].when) {
    const Condition& besides = model_.conditions[other.id];
    if (besides.state == condition.state || is_servable(waiter, other.id)) continue;
    Possible& left = possible_in(model_, facts_, besides.state, start);
    left = {left.values.intersected(besides.accepts), false};
  }
  const std::vector<Region>& ways = ways_.of(model_.providers[waiter].group);
  return find_covering(model_, facts_.values, start, ways, budget_) == Covering::open;
}

bool Standstill::is_servable(ProviderId waiter, ConditionId id) const {
  return std::any_of(causers_[id].begin(), causers_[id].end(), [&](ProviderId causer) {
    return model_.providers[causer].group != model_.providers[waiter].group && facts_.capable.contains(causer);
  });
}

} // namespace director::analysis
