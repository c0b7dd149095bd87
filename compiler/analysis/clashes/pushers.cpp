// Header: compiler/analysis/clashes/pushers.hpp. Test: tests/compiler/analysis/clashes/pushers_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/clashes/pushers.hpp"

#include "compiler/analysis/chains/sparse_set.hpp"
#include "compiler/analysis/shared/shared.hpp"

#include <algorithm>

namespace director::analysis {

namespace {

/// Limit for the providers causing one condition that are considered as preferred to one of them; the earliest are
/// taken.
constexpr std::size_t most_preferred = 16;

} // namespace

Pushers::Pushers(const Input& input)
    : input_(input),
      waiting_(input.model, input.facts),
      pushes_(input.model, input.facts, input.shared.chains(), input.shared.causers()) {
  for (const Wanting& wanting : input.shared.wants()) {
    for (const Want& want : wanting.wants) {
      for (const ProviderId causer : want.causers) direct_.insert({causer, want.condition.id});
    }
  }
  for (const ConditionId wanted : input.model.conditions.ids()) {
    for (const ProviderId id : input.shared.causers()[wanted]) {
      if (!input.facts.pushed.contains(id)) continue;
      for (const ConditionUse& use : input.model.providers[id].when) {
        if (pushes_.may_lack_with(use.id, wanted)) in_chains_.insert(use.id);
      }
    }
  }
  SparseSet<GroupId> seen;
  std::vector<GroupId> open;
  const auto add = [&](ProviderId id) {
    for (const Use<GroupId>& need : input.model.providers[id].needs) {
      if (input.facts.may_wait.contains(need.id) && seen.add(need.id)) open.push_back(need.id);
    }
  };
  for (const ProviderId id : input.model.providers.ids()) {
    if (input.facts.pushed.contains(id)) add(id);
  }
  while (!open.empty()) {
    const GroupId group = open.back();
    open.pop_back();
    for (const ProviderId id : input.model.groups[group].providers) {
      for (const ConditionUse& use : input.model.providers[id].when) in_chains_.insert(use.id);
      add(id);
    }
  }
}

bool Pushers::may_push(ProviderId causer, ConditionId condition) {
  if (is_requested_after(causer, condition) || pushes_.is_passed_over(causer, condition)) return false;
  if (direct_.count({causer, condition}) != 0 || is_pushed_in_chain(causer, condition)) return true;
  const std::vector<Waiter>& all = waiters(condition);
  return std::any_of(all.begin(), all.end(), [&](const Waiter& waiter) {
    return is_idle_pusher(waiter, causer, condition) || is_beside(waiter, causer, condition);
  });
}

const std::vector<Pushers::Waiter>& Pushers::waiters(ConditionId condition) {
  const auto [at, is_new] = waiters_.try_emplace(condition);
  std::vector<Waiter>& out = at->second;
  if (!is_new) return out;
  const Model& model = input_.model;
  SparseSet<GroupId> seen;
  std::vector<GroupId> open;
  for (const ProviderId id : model.providers.ids()) {
    const Provider& provider = model.providers[id];
    const bool looks = std::any_of(provider.when.begin(), provider.when.end(),
                                   [&](const ConditionUse& use) { return use.id == condition; });
    if (looks && seen.add(provider.group)) open.push_back(provider.group);
  }
  for (std::size_t next = 0; next < open.size(); ++next) {
    const GroupId group = open[next];
    for (const EdgeId edge : model.groups[group].requesters) {
      if (model.edges[edge].needed && seen.add(*model.edges[edge].requester))
        open.push_back(*model.edges[edge].requester);
    }
    if (!input_.facts.requested.contains(group)) continue;
    const std::vector<ProviderId>& all = model.groups[group].providers;
    out.push_back({group, std::any_of(all.begin(), all.end(),
                                      [&](ProviderId id) { return !input_.facts.capable.contains(id); })});
  }
  std::sort(out.begin(), out.end(), [](const Waiter& a, const Waiter& b) { return a.task < b.task; });
  return out;
}

/// Whether its group is requested only while the condition holds.
bool Pushers::is_requested_after(ProviderId causer, ConditionId condition) const {
  const GroupId group = input_.model.providers[causer].group;
  const std::vector<EdgeId>& above = input_.model.groups[group].requesters;
  const bool may_be_kept = std::any_of(above.begin(), above.end(), [&](EdgeId id) {
    if (!input_.model.edges[id].requester) return false;
    const std::vector<EdgeId>& next = input_.model.groups[*input_.model.edges[id].requester].requesters;
    return std::any_of(next.begin(), next.end(), [&](EdgeId each) { return input_.model.edges[each].requester; });
  });
  return !may_be_kept && input_.facts.holds_always(input_.model, condition, input_.facts.contexts[group]);
}

/// A provider that never runs for another, reported reason may still be what the task waits for.
bool Pushers::is_idle_pusher(const Waiter& waiter, ProviderId causer, ConditionId condition) {
  return waiter.idle && PushSearch(pushes_, waiter.task).may_push(causer, condition);
}

/// Whether it is pushed for another push. Which task makes that push, and whether it goes before this group, is
/// ignored.
bool Pushers::is_pushed_in_chain(ProviderId causer, ConditionId condition) {
  return input_.facts.pushed.contains(causer) && in_chains_.count(condition) != 0;
}

/// Members of one unit push each other, although that seldom has an effect: none is granted without the others, except
/// below a stale requester.
bool Pushers::is_beside(const Waiter& waiter, ProviderId causer, ConditionId condition) {
  const GroupId group = input_.model.providers[causer].group;
  if (input_.facts.holds_always(input_.model, condition, input_.facts.contexts[waiter.task]) ||
      !waiting_.may_wait(waiter.task))
    return false;
  bool out = false;
  input_.shared.chains().visit(waiter.task, {group}, [&](const Meeting& meeting, GroupId) {
    if (out || !meeting.one_unit() || meeting.second->target != group || !meeting.first_goes_before()) return;
    // Tasks that can never be granted together wait for no condition; and a task below one member finds the other one
    // granted.
    out = meeting.first->target != waiter.task
              ? !is_sure(group)
              : input_.shared.units().verdict({waiter.task, group}, true) != UnitVerdict::impossible;
  });
  return out;
}

/// Whether nothing takes it from its only requester, and nothing stops it.
bool Pushers::is_sure(GroupId group) const {
  const Group& row = input_.model.groups[group];
  return row.requesters.size() == 1 && std::all_of(row.providers.begin(), row.providers.end(), [&](ProviderId id) {
           const Provider& provider = input_.model.providers[id];
           return provider.when.empty() && provider.needs.empty();
         });
}

std::optional<ProviderId> Pushers::preferred(ProviderId causer, ConditionId condition) {
  if (const auto earlier = pushes_.earlier_causer(causer, condition)) return earlier;
  std::size_t tried = 0;
  for (const ProviderId rival : input_.shared.causers()[condition]) {
    if (rival == causer || tried++ == most_preferred) break;
    if (comes_first(rival, causer, condition)) return rival;
  }
  return std::nullopt;
}

/// The shortest chain, then the earliest declaration.
bool Pushers::comes_first(ProviderId rival, ProviderId causer, ConditionId condition) {
  const Model& model = input_.model;
  const GroupId group = model.providers[rival].group;
  return rival < causer && group != model.providers[causer].group && model.providers[rival].needs.empty() &&
         pushes_.holds_with(rival, causer, condition) &&
         input_.shared.chains().always_below(model.providers[causer].group, group) &&
         is_free_for(rival, causer, condition);
}

/// Whether some chain of requests and needs leads from the group to the task, with whatever states: a request remains
/// while another provider of its requester runs, so the two may have conditions that exclude each other.
bool Pushers::leads_to(GroupId group, GroupId task) const {
  SparseSet<GroupId> seen;
  std::vector<GroupId> open{group};
  while (!open.empty()) {
    const GroupId here = open.back();
    open.pop_back();
    for (const EdgeId id : input_.model.groups[here].edges) {
      const GroupId next = input_.model.edges[id].target;
      if (!input_.facts.holding.contains(id)) continue;
      if (next == task) return true;
      if (seen.add(next)) open.push_back(next);
    }
  }
  return false;
}

/// Whether each task that waits for the condition goes before this group, which is not held for a need, and pushes no
/// other group there.
bool Pushers::is_free_for(ProviderId rival, ProviderId causer, ConditionId condition) {
  const Model& model = input_.model;
  const Chains& chains = input_.shared.chains();
  const GroupId group = model.providers[rival].group;
  const std::vector<EdgeId>& requesters = model.groups[group].requesters;
  if (in_chains_.count(condition) != 0 ||
      std::any_of(requesters.begin(), requesters.end(), [&](EdgeId id) { return model.edges[id].needed; }))
    return false;
  for (const ProviderId id : model.groups[group].providers) {
    if (id != rival && input_.facts.pushed.contains(id)) return false;
  }
  const std::vector<Waiter>& all = waiters(condition);
  return std::all_of(all.begin(), all.end(), [&](const Waiter& waiter) {
    if (!chains.may_beat(waiter.task, model.providers[causer].group) && !is_beside(waiter, causer, condition))
      return true;
    if (waiter.task == group || leads_to(group, waiter.task)) return false; // it is granted by then
    bool always = true;
    chains.visit(waiter.task, {group}, [&](const Meeting& meeting, GroupId) {
      always = always && meeting.first_goes_before() && !meeting.one_unit();
    });
    return always;
  });
}

} // namespace director::analysis
