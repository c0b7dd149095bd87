// Header: compiler/analysis/facts/waiting.hpp. Test: tests/compiler/analysis/facts/waiting_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/waiting.hpp"

#include "compiler/analysis/states/covering.hpp"

#include <algorithm>

namespace director::analysis {

bool needs_no_more(const Provider& first, const Provider& second) {
  return std::all_of(first.needs.begin(), first.needs.end(), [&](const Use<GroupId>& need) {
    return std::any_of(second.needs.begin(), second.needs.end(),
                       [&](const Use<GroupId>& other) { return other.id == need.id; });
  });
}

bool can_always_replace(const Model& model, ProviderId id, ProviderId other) {
  const Region own = region_of(model, model.providers[id].when), others = region_of(model, model.providers[other].when);
  return needs_no_more(model.providers[id], model.providers[other]) &&
         std::all_of(own.states.begin(), own.states.end(), [&](const auto& entry) {
           const auto at = others.states.find(entry.first);
           return at != others.states.end() && at->second.subset_of(entry.second);
         });
}

bool Waiting::may_be_first(ProviderId id) const {
  if (facts_.pushed.contains(id)) return true;
  const Provider& provider = model_.providers[id];
  for (const ProviderId earlier : model_.groups[provider.group].providers) {
    if (earlier == id) break;
    if (facts_.plans[earlier] == PlanVerdict::found && needs_no_more(model_.providers[earlier], provider)) return false;
  }
  return true;
}

Waiting::Waiting(const Model& model, const Facts& facts) : model_(model), facts_(facts) {
  for (const ProviderId id : model.providers.ids()) {
    for (const Pack& pack : model.providers[id].packs) {
      for (const Task& task : pack.tasks) entries_[task.edge].push_back({id, &pack, model.may_be_member(task)});
    }
  }
}

bool Waiting::may_wait(GroupId group) {
  for (const EdgeId edge : model_.groups[group].requesters) {
    if (model_.edges[edge].levels.empty()) continue;
    if (!model_.edges[edge].requester) {
      if (!always_finds_choice(group, facts_.contexts[group])) return true;
      continue;
    }
    for (const Entry& entry : entries_[edge]) {
      if (!facts_.active.contains(entry.provider)) continue;
      if (!always_finds_choice(group, facts_.contexts[group]) || (entry.in_unit && unit_waits(*entry.pack)))
        return true;
    }
  }
  return false;
}

bool Waiting::unit_waits(const Pack& pack) {
  const auto [at, is_new] = unit_waits_.try_emplace(&pack, false);
  if (!is_new) return at->second;
  const bool out = std::any_of(pack.tasks.begin(), pack.tasks.end(), [&](const Task& task) {
    return model_.may_be_member(task) && !always_finds_choice(task.target, facts_.contexts[task.target]);
  });
  return unit_waits_[&pack] = out;
}

bool Waiting::always_finds_choice(GroupId group, const Region& context) {
  const auto [at, is_new] = carefree_.try_emplace(group, false);
  if (!is_new) return at->second;
  std::set<GroupId> seen;
  std::map<GroupId, bool> known;
  const bool out = holds_always(group, context, seen) || can_do_without(group, context, known);
  return carefree_[group] = out;
}

/// Whether, wherever the groups of one of its choices are available, some of them form a choice whose conditions hold.
bool Waiting::can_do_without(GroupId group, const Region& context, std::map<GroupId, bool>& known) const {
  if (!facts_.may_wait.contains(group)) return true;
  const auto [at, is_new] = known.try_emplace(group, false); // false: it is above itself
  if (!is_new) return at->second;
  const std::vector<ProviderId>& all = model_.groups[group].providers;
  std::vector<Region> serving;
  const Provider* fewest = nullptr; ///< whose needs are among those of all others, if there is one
  for (const ProviderId id : all) {
    if (fewest == nullptr || model_.providers[id].needs.size() < fewest->needs.size()) fewest = &model_.providers[id];
  }
  const bool common =
      std::all_of(all.begin(), all.end(), [&](ProviderId id) { return needs_no_more(*fewest, model_.providers[id]); });
  for (const ProviderId id : all) {
    const Provider& provider = model_.providers[id];
    const bool serves = common && facts_.plans[id] == PlanVerdict::found && needs_no_more(provider, *fewest) &&
                        std::all_of(provider.needs.begin(), provider.needs.end(),
                                    [&](const Use<GroupId>& need) { return can_do_without(need.id, context, known); });
    if (serves) serving.push_back(region_of(model_, provider.when));
  }
  if (serving.empty()) return false;
  if (std::any_of(serving.begin(), serving.end(), [](const Region& region) { return region.states.empty(); }))
    return known[group] = true;
  Budget budget = facts_.budget; // a copy, so that an open question is not reported
  return known[group] =
             find_covering(model_, facts_.values, box_of(facts_.values, context), serving, budget) == Covering::covered;
}

/// Whether every condition of it, and of its possible needs, holds.
bool Waiting::holds_always(GroupId group, const Region& context, std::set<GroupId>& seen) const {
  if (!facts_.may_wait.contains(group) || !seen.insert(group).second) return true;
  const std::vector<ProviderId>& all = model_.groups[group].providers;
  return std::all_of(all.begin(), all.end(), [&](ProviderId id) {
    const Provider& provider = model_.providers[id];
    return std::all_of(provider.when.begin(), provider.when.end(),
                       [&](const ConditionUse& use) { return facts_.holds_always(model_, use.id, context); }) &&
           std::all_of(provider.needs.begin(), provider.needs.end(),
                       [&](const Use<GroupId>& need) { return holds_always(need.id, context, seen); });
  });
}

} // namespace director::analysis
