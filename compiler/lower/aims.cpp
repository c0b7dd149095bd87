// Header: compiler/lower/steps.hpp. Test: tests/compiler/lower/lower_test.cpp.
// SPDX-License-Identifier: MIT
//
// Finds what a causing provider itself waits for, with its plans: a push that serves one of these serves the task that
// wants what the provider causes. If a provider has too many plans, its aims are those of everything that it may need:
// an over-approximation by providers which can never be picked together, which at most makes a push last longer.

#include "compiler/lower/plans.hpp"
#include "compiler/lower/steps.hpp"

#include <set>

namespace director::compiler {

namespace {

void add_conditions(const Provider& provider, const Lowered& out, std::set<Index>& rows) {
  for (const ConditionUse& use : provider.when) rows.insert(*condition_row(out, use.id));
  for (const ConditionUse& use : provider.stay) rows.insert(*condition_row(out, use.id));
}

} // namespace

void lower_aims(const Model& model, Lowered& out) {
  for (const ProviderId id : model.providers.ids()) {
    if (model.providers[id].causing.empty()) continue;
    std::set<Index> aims;
    add_conditions(model.providers[id], out, aims);
    const PlanProviders in_plans = providers_in_plans(model, id);
    for (const ProviderId other : in_plans.providers) add_conditions(model.providers[other], out, aims);
    if (!in_plans.exact) out.wide_aims.push_back(id);
    out.providers[id.value].aims = add_list(out, std::vector<Index>(aims.begin(), aims.end()));
  }
}

} // namespace director::compiler
