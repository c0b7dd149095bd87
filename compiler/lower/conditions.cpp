// Header: compiler/lower/steps.hpp. Test: tests/compiler/lower/lower_test.cpp.
// SPDX-License-Identifier: MIT
//
// Only conditions with effect have rows: those in `when` and `stay`, and promises with a time limit. Causing providers
// are found per state, so that the cost is that of the possible pairs.

#include "compiler/lower/steps.hpp"
#include "compiler/model/causers.hpp"

#include <set>

namespace director::compiler {

namespace {

void number_conditions(const Model& model, Lowered& out) {
  std::set<ConditionId> used;
  for (const Provider& provider : model.providers) {
    for (const ConditionUse& use : provider.when) used.insert(use.id);
    for (const ConditionUse& use : provider.stay) used.insert(use.id);
    for (const ConditionUse& use : provider.causing) {
      if (use.within) used.insert(use.id);
    }
  }
  out.condition_ids.assign(used.begin(), used.end());
}

Range add_intervals(const ValueSet& accepts, Lowered& out) {
  const auto begin = static_cast<Index>(out.intervals.size());
  for (const ValueSet::Interval& interval : accepts.intervals()) {
    out.intervals.push_back({static_cast<std::int32_t>(interval.low), static_cast<std::int32_t>(interval.high)});
  }
  return {begin, static_cast<Index>(out.intervals.size())};
}

} // namespace

void lower_conditions(const Model& model, Lowered& out) {
  number_conditions(model, out);
  const Causers causers_of = find_causers(model);
  for (const ConditionId id : out.condition_ids) {
    const Condition& condition = model.conditions[id];
    std::vector<Index> causers;
    for (const ProviderId provider : causers_of[id]) causers.push_back(row(provider));
    director::Condition lowered;
    lowered.state = row(condition.state);
    lowered.accepts = add_intervals(condition.accepts, out);
    lowered.causers = add_list(out, causers);
    out.conditions.push_back(lowered);
  }
}

} // namespace director::compiler
