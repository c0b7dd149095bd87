// Header: compiler/analysis/rounds/settings.hpp. Test: compiler/checks/undone_by_stop.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/rounds/settings.hpp"

#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace director::analysis {

bool Settings::may_be_granted_alone(GroupId task) const {
  const std::vector<Request>& requests = shared_.requests().of(task);
  return std::any_of(requests.begin(), requests.end(), [&](const Request& request) {
    return !request.requester || !model_.may_be_member(*request.task);
  });
}

bool Settings::takes_all(ProviderId id) const {
  const std::vector<ProviderId>& all = model_.group_of(id).providers;
  return std::all_of(all.begin(), all.end(), [&](ProviderId other) {
    const Provider& row = model_.providers[other];
    return other == id || !facts_.active.contains(other) || (row.needs.empty() && row.packs.empty());
  });
}

bool Settings::is_kept_off(ProviderId waiter, GroupId group) const {
  const std::vector<Use<GroupId>>& needs = model_.providers[waiter].needs;
  const std::vector<Request>& requests = shared_.requests().of(group);
  return std::all_of(requests.begin(), requests.end(), [&](const Request& request) {
    return request.requester && std::any_of(needs.begin(), needs.end(), [&](const Use<GroupId>& need) {
             return shared_.indispensable().needs_contain(model_.providers[*request.requester], need.id);
           });
  });
}

bool Settings::never_runs(ProviderId id) const {
  return !facts_.impossible_of(id).empty() || grants_.idle().count(id) != 0 ||
         !grants_.is_tried(model_.providers[id].group);
}

std::optional<Setting> Settings::find_setting(ProviderId waiter, const ConditionUse& use, GroupId group,
                                              const std::optional<ValueSet>& values) const {
  const StateId state = model_.conditions[use.id].state;
  Region here = region_of(model_, model_.providers[waiter].when);
  here.states.erase(state);
  if (values) {
    ValueSet undoing = values->without(model_.conditions[use.id].accepts);
    if (undoing.empty()) return std::nullopt;
    here.states.emplace(state, std::move(undoing));
  }
  for (const ProviderId id : model_.groups[group].providers) {
    const Provider& row = model_.providers[id];
    const Region own = region_of(model_, row.when);
    if (!facts_.chosen.contains(id) || never_runs(id) || !compatible(here, own)) continue;
    if (!values && own.states.count(state) != 0) continue;
    for (const ConditionUse& entry : row.sets) {
      if (model_.satisfies(entry.id, use.id))
        return Setting{id, {entry.span, fmt::format("{} may set {}", name_of(model_, id), name_of(model_, entry.id))}};
    }
    if (contains(own, here)) break;
  }
  return std::nullopt;
}

std::optional<Setting> Settings::find_start(ProviderId waiter, const ConditionUse& use, GroupId group,
                                            const ValueSet& values) const {
  const Group& row = model_.groups[group];
  const Condition& condition = model_.conditions[use.id];
  Region before = region_of(model_, model_.providers[waiter].when);
  const Region here = before;
  before.states[condition.state] = values.without(condition.accepts);
  if (!row.start || before.states[condition.state].empty()) return std::nullopt;
  const auto entry = std::find_if(row.start->sets.begin(), row.start->sets.end(),
                                  [&](const ConditionUse& each) { return model_.satisfies(each.id, use.id); });
  const auto begins = std::find_if(row.providers.begin(), row.providers.end(), [&](ProviderId id) {
    return facts_.chosen.contains(id) && !never_runs(id) &&
           compatible(before, region_of(model_, model_.providers[id].when));
  });
  // Otherwise the group stops by itself then.
  const bool continues = std::any_of(row.providers.begin(), row.providers.end(), [&](ProviderId id) {
    return facts_.active.contains(id) && compatible(here, active_region(model_, model_.providers[id]));
  });
  if (entry == row.start->sets.end() || begins == row.providers.end() || !continues) return std::nullopt;
  return Setting{
      *begins,
      {entry->span, fmt::format("the start of {} may set {}", name_of(model_, group), name_of(model_, entry->id))}};
}

} // namespace director::analysis
