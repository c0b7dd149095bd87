// Header: compiler/analysis/facts/excluded.hpp. Test: tests/compiler/analysis/facts/facts_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/excluded.hpp"

#include <algorithm>
#include <vector>

namespace director::analysis {

namespace {

/// The target runs for others, but its providers never can where this group requests it.
void exclude_task(const Model& model, Contexts& contexts, Facts& facts, GroupId requester, GroupId target,
                  const Contexts::Requested& requested) {
  const std::vector<ProviderId>& all = model.groups[target].providers;
  const auto runs = [&](ProviderId each) { return facts.active.contains(each); };
  if (requested.granted.states.empty() || std::none_of(all.begin(), all.end(), runs) ||
      std::any_of(all.begin(), all.end(), [&](ProviderId each) {
        return facts.capable.contains(each) && contexts.can_go_on(each, requested.granted);
      }))
    return;
  for (const EdgeId id : model.groups[target].requesters) {
    if (model.edges[id].requester == requester && !model.edges[id].levels.empty()) facts.excluded_tasks.push_back(id);
  }
}

} // namespace

void find_excluded(const Model& model, Contexts& contexts, Facts& facts) {
  for (const ProviderId id : model.providers.ids()) {
    const GroupId group = model.providers[id].group;
    if (facts.requested.contains(group) && facts.capable.contains(id) && !facts.active.contains(id) &&
        !contexts.can_begin(id, facts.grants[group]))
      facts.excluded.add(id);
  }
  for (const GroupId group : model.groups.ids()) {
    contexts.visit_below(group, [&](GroupId target, const Contexts::Requested& requested) {
      exclude_task(model, contexts, facts, group, target, requested);
    });
  }
  std::sort(facts.excluded_tasks.begin(), facts.excluded_tasks.end());
}

} // namespace director::analysis
