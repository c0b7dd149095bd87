// Header: tests/property/verdicts.hpp. Test: tests/property/verdicts_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/decisions/decisions.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "tests/property/verdicts.hpp"

#include <algorithm>

namespace director::property {

using compiler::ConditionId;
using compiler::EdgeId;
using compiler::GroupId;
using compiler::ProviderId;

namespace {

bool reports_any(const compiler::Model& model, const analysis::Facts& facts) {
  const auto ids = model.providers.ids();
  return !facts.impossible.empty() || std::any_of(ids.begin(), ids.end(), [&](ProviderId id) {
    return facts.plans[id] == analysis::PlanVerdict::none;
  });
}

} // namespace

FollowOn follow_on_of(const compiler::Model& model) {
  using analysis::Reported;
  const compiler::Graph graph = compiler::make_graph(model);
  const analysis::Facts corrected = analysis::find_facts(model, graph),
                        facts = analysis::find_facts(model, graph, Reported::as_is);
  FollowOn out;
  if (!reports_any(model, corrected)) return out;
  for (const ProviderId id : model.providers.ids()) {
    if (corrected.active.contains(id) && !facts.active.contains(id)) out.idle.push_back(id);
    if (corrected.pushed.contains(id) && !facts.pushed.contains(id)) out.unpushed.push_back(id);
  }
  // What is known of both, and never happens only because of the declarations.
  analysis::Budget budget, other_budget;
  const analysis::Decisions as_is = analysis::find_decisions(model, facts, Reported::as_is, budget),
                            as_corrected =
                                analysis::find_decisions(model, corrected, Reported::corrected, other_budget);
  const auto is_told = [&](GroupId group, const auto& never) {
    return as_is.decided.contains(group) && never(as_is) && as_corrected.looked_at.contains(group) &&
           !(as_corrected.decided.contains(group) && never(as_corrected));
  };
  for (const ProviderId id : model.providers.ids()) {
    const GroupId group = model.providers[id].group;
    if (is_told(group, [&](const auto& found) { return !found.runs.contains(id); })) out.idle.push_back(id);
    for (std::size_t i = 0; i < model.providers[id].packs.size(); ++i) {
      if (is_told(group, [&](const auto& found) { return !found.whole.contains({id, i}); }))
        out.unwhole.emplace_back(id, i);
    }
    for (const ConditionId condition : model.conditions.ids()) {
      if (is_told(group, [&](const auto& found) { return !found.pushed.contains({id, condition}); }))
        out.unpushed_for.emplace_back(id, condition);
    }
  }
  for (const EdgeId id : model.edges.ids()) {
    if (is_told(model.edges[id].target, [&](const auto& found) { return !found.granted.contains(id); }))
      out.ungranted.push_back(id);
  }
  return out;
}

} // namespace director::property
