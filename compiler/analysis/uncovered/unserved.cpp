// Header: compiler/analysis/uncovered/unserved.hpp. Test: compiler/checks/uncovered_state.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/uncovered/unserved.hpp"

#include "compiler/analysis/causing/promises.hpp"
#include "compiler/analysis/causing/self_defeats.hpp"
#include "compiler/analysis/needs/units.hpp"
#include "compiler/analysis/shared/shared.hpp"

#include <algorithm>
#include <utility>

namespace director::analysis {

Unserved::Unserved(const Input& input)
    : model_(input.model),
      facts_(input.facts),
      shared_(input.shared),
      cycles_(model_, facts_, shared_.causers()),
      explained_(input.shared.promises().explained) {
  for (const Imprecise& fault : shared_.imprecise()) explained_.add(fault.waiter);
  for (const Clash& clash : input.conflicts.clashes()) {
    explained_.add(clash.first_waiter);
    explained_.add(clash.second_waiter);
  }
  for (const SelfDefeat& fault : find_self_defeats(model_, facts_)) {
    if (!fault.stop) explained_.add(fault.provider);
  }
  for (const PackConflict& conflict : input.conflicts.pack_conflicts()) {
    if (!model_.providers[conflict.provider].has_packs || conflict.verdict != UnitVerdict::impossible) continue;
    for (const Task* member : conflict.members) conflicting_.insert(member);
    for (const Task* member : conflict.others) conflicting_.insert(member);
  }
  for (const Wanting& wanting : shared_.wants()) {
    for (const Want& want : wanting.wants) pushed_.insert({wanting.task, want.condition.id});
  }
  for (const Outranked& one : input.conflicts.outranked()) reported_.insert({one.request->target, one.condition.id});
  for (const HeldPush& held : input.conflicts.held_pushes()) reported_.insert({held.waits->target, held.wanted.id});
}

bool Unserved::counts(GroupId group, ProviderId provider, const ConditionUse& use) const {
  if (explained_.contains(provider) || reported_.count({group, use.id}) != 0) return false;
  if (ends_requests(group, use)) return true;
  if (beginnings(group, provider, use)) return true;
  if (pushed_.count({group, use.id}) != 0) return false;
  const std::vector<ProviderId>& causers = shared_.causers()[use.id];
  return std::none_of(causers.begin(), causers.end(),
                      [&](ProviderId causer) { return may_cause(group, provider, causer); });
}

bool Unserved::ends_requests(GroupId group, const ConditionUse& use) const {
  const std::vector<Request>& requests = shared_.requests().of(group);
  return !requests.empty() && std::all_of(requests.begin(), requests.end(), [&](const Request& request) {
    return request.requester && !may_request_with(*request.requester, use);
  });
}

bool Unserved::may_request_with(ProviderId requester, const ConditionUse& use) const {
  const Condition& condition = model_.conditions[use.id];
  const Region region = facts_.region_to_run(model_, requester, facts_.pushed.contains(requester));
  const auto at = region.states.find(condition.state);
  return at == region.states.end() || at->second.overlaps(condition.accepts);
}

bool Unserved::may_cause(GroupId group, ProviderId provider, ProviderId causer) const {
  return model_.providers[causer].group != group && facts_.chosen.contains(causer) && facts_.active.contains(causer) &&
         !shared_.push_exclusion().find_outside(provider, causer);
}

const std::optional<std::vector<Region>>& Unserved::beginnings(GroupId group, ProviderId provider,
                                                               const ConditionUse& use) const {
  const auto [at, is_new] = beginnings_.try_emplace({group, provider, use.id});
  if (is_new)
    at->second = cycles_.beginnings(use.id, [&](ProviderId causer) { return may_cause(group, provider, causer); });
  return at->second;
}

void Unserved::add_cycles(GroupId group, std::vector<Region>& ways) const {
  for (const ProviderId id : model_.groups[group].providers) {
    for (const ConditionUse& use : model_.providers[id].when) {
      const std::optional<std::vector<Region>>& found = beginnings(group, id, use);
      if (!found || ends_requests(group, use)) continue;
      for (Region way : *found) {
        for (const ConditionUse& other : model_.providers[id].when) {
          if (other.id == use.id || !counts(group, id, other)) continue;
          way.meet(model_.conditions[other.id].state, model_.conditions[other.id].accepts);
        }
        if (!way.empty()) ways.push_back(std::move(way));
      }
    }
  }
}

bool Unserved::never_runs(GroupId group) const {
  const std::vector<ProviderId>& all = model_.groups[group].providers;
  return std::all_of(all.begin(), all.end(),
                     [&](ProviderId id) {
                       SparseSet<GroupId> seen;
                       return !facts_.active.contains(id) && !is_reported(id, seen);
                     }) &&
         !waits_with_reported(group);
}

bool Unserved::is_in_conflict(GroupId group) const {
  const std::vector<Request>& requests = shared_.requests().of(group);
  return facts_.capable_groups.contains(group) &&
         std::all_of(requests.begin(), requests.end(), [&](const Request& request) {
           return request.requester && conflicting_.count(request.task) != 0 && model_.is_always_member(*request.task);
         });
}

bool Unserved::waits_with_reported(GroupId group) const {
  bool any = false;
  for (const EdgeId edge : model_.groups[group].requesters) {
    if (model_.edges[edge].levels.empty()) continue;
    if (!model_.edges[edge].requester) return false;
    for (const ProviderId id : model_.groups[*model_.edges[edge].requester].providers) {
      if (!facts_.active.contains(id)) continue;
      for (const Pack& pack : model_.providers[id].packs) {
        const auto is_it = [&](const Task& task) { return task.target == group; };
        if (std::none_of(pack.tasks.begin(), pack.tasks.end(), is_it)) continue;
        if (!model_.providers[id].has_packs || !waits_with_reported(group, unit_members(model_, pack))) return false;
        any = true;
      }
    }
  }
  return any;
}

bool Unserved::waits_with_reported(GroupId group, const std::vector<const Task*>& members) const {
  const auto is_it = [&](const Task* member) { return member->target == group; };
  return std::any_of(members.begin(), members.end(), is_it) &&
         std::any_of(members.begin(), members.end(), [&](const Task* member) {
           if (member->target == group || facts_.capable_groups.contains(member->target)) return false;
           const std::vector<ProviderId>& all = model_.groups[member->target].providers;
           return std::all_of(all.begin(), all.end(), [&](ProviderId each) {
             SparseSet<GroupId> seen;
             return is_reported(each, seen);
           });
         });
}

bool Unserved::is_reported(ProviderId id, SparseSet<GroupId>& seen) const {
  const auto faults = facts_.impossible_of(id);
  const std::vector<Use<GroupId>>& needs = model_.providers[id].needs;
  return explained_.contains(id) || facts_.plans[id] != PlanVerdict::found ||
         std::any_of(faults.begin(), faults.end(), [](const Impossible& fault) { return !fault.stay; }) ||
         std::any_of(needs.begin(), needs.end(), [&](const Use<GroupId>& need) {
           if (facts_.capable_groups.contains(need.id) || !seen.add(need.id)) return false;
           const std::vector<ProviderId>& below = model_.groups[need.id].providers;
           return std::any_of(below.begin(), below.end(), [&](ProviderId each) { return is_reported(each, seen); });
         });
}

Ways Unserved::ways_for(GroupId task) const {
  return {model_, facts_, true,
          [this, task](ProviderId provider, const ConditionUse& use) { return counts(task, provider, use); }};
}

} // namespace director::analysis
