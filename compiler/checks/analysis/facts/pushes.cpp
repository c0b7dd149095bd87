// Door: compiler/checks/analysis/facts/pushes.hpp. Test: tests/checks/analysis/facts/facts_test.cpp.
#include "compiler/checks/analysis/facts/pushes.hpp"

#include <algorithm>

namespace director::checks {

namespace {

/// The providers of the group and of every group that their plans may hold, as far as one of them waits for anything.
std::vector<ProviderId> providers_of_plans(const Model& model, const Facts& facts, GroupId waiter) {
  std::vector<ProviderId> out;
  if (!facts.may_wait.contains(waiter)) return out;
  std::vector<GroupId> open{waiter};
  SparseSet<GroupId> seen;
  seen.add(waiter);
  while (!open.empty()) {
    const GroupId group = open.back();
    open.pop_back();
    for (const ProviderId id : model.groups[group].providers) {
      out.push_back(id);
      for (const Use<GroupId>& need : model.providers[id].needs) {
        if (facts.may_wait.contains(need.id) && seen.add(need.id)) open.push_back(need.id);
      }
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

class GoalSearch {
public:
  GoalSearch(const Model& model, const Facts& facts, const Chains& chains, const Causers& causers, GroupId waiter)
      : model_(model),
        facts_(facts),
        causers_of_(causers),
        providers_(providers_of_plans(model, facts, waiter)) {
    collect_conditions();
    std::vector<GroupId> others;
    for (const ProviderId causer : causers_) others.push_back(model.providers[causer].group);
    others.erase(std::unique(others.begin(), others.end()), others.end());
    if (!others.empty()) goals_.beaten = chains.beaten_by(waiter, others);
  }

  PushGoals run() {
    find_servable();
    if (causers_.empty()) return std::move(goals_);
    SparseSet<ConditionId> wanted;
    std::vector<ConditionId> open;
    const auto want = [&](ProviderId provider) {
      if (!can_be_completed(provider)) return;
      for (const ConditionUse& use : model_.providers[provider].when) {
        if (!facts_.is_impossible(provider, model_.conditions[use.id].state) && wanted.add(use.id))
          open.push_back(use.id);
      }
    };
    SparseSet<ProviderId> pushable;
    for (const ProviderId provider : providers_) want(provider);
    while (!open.empty()) {
      const ConditionId condition = open.back();
      open.pop_back();
      for (const ProviderId causer : causers_of_[condition]) {
        if (!serves(causer)) continue;
        pushable.add(causer);
        want(causer);
      }
    }
    for (const ProviderId causer : causers_) {
      if (pushable.contains(causer)) goals_.pushable.push_back(causer);
    }
    return std::move(goals_);
  }

private:
  /// The conditions that matter, by way of causing providers and theirs; and these providers.
  void collect_conditions() {
    SparseSet<ConditionId> seen;
    SparseSet<ProviderId> taken;
    const auto add = [&](ProviderId provider) {
      for (const ConditionUse& use : model_.providers[provider].when) {
        if (seen.add(use.id)) conditions_.push_back(use.id);
      }
    };
    for (const ProviderId provider : providers_) add(provider);
    for (std::size_t next = 0; next < conditions_.size(); ++next) {
      for (const ProviderId causer : causers_of_[conditions_[next]]) {
        if (!taken.add(causer)) continue;
        causers_.push_back(causer);
        add(causer);
      }
    }
    std::sort(causers_.begin(), causers_.end());
  }

  bool may_hold(ConditionId id) const {
    const Condition& condition = model_.conditions[id];
    return !facts_.values[condition.state].intersected(condition.accepts).empty();
  }

  /// A soft transition is begun only when it can be completed.
  bool can_be_completed(ProviderId provider) const {
    const std::vector<ConditionUse>& when = model_.providers[provider].when;
    return std::all_of(when.begin(), when.end(), [&](const ConditionUse& use) {
      return goals_.servable.contains(use.id) || facts_.is_impossible(provider, model_.conditions[use.id].state);
    });
  }

  /// The conditions that it causes.
  bool serves(ProviderId causer) const {
    const GroupId group = model_.providers[causer].group;
    return facts_.requested.contains(group) && goals_.beaten.contains(group) && can_be_completed(causer);
  }

  void find_servable() {
    // Backwards: what a condition waits for was collected behind it.
    for (bool changed = true; changed;) {
      changed = false;
      for (auto at = conditions_.rbegin(); at != conditions_.rend(); ++at) {
        const ConditionId id = *at;
        if (goals_.servable.contains(id)) continue;
        const bool now = may_hold(id) || std::any_of(causers_of_[id].begin(), causers_of_[id].end(),
                                                     [&](ProviderId causer) { return serves(causer); });
        if (now) changed = goals_.servable.add(id);
      }
    }
  }

  const Model& model_;
  const Facts& facts_;
  const Causers& causers_of_;
  std::vector<ProviderId> providers_;
  std::vector<ConditionId> conditions_;
  std::vector<ProviderId> causers_;
  PushGoals goals_;
};

} // namespace

Causers find_causers(const Model& model) {
  IdTable<StateId, std::vector<ProviderId>> by_state(model.states.size());
  for (const ProviderId id : model.providers.ids()) {
    for (const ConditionUse& promise : model.providers[id].causing) {
      std::vector<ProviderId>& row = by_state[model.conditions[promise.id].state];
      if (row.empty() || row.back() != id) row.push_back(id);
    }
  }
  Causers out(model.conditions.size());
  for (const ConditionId condition : model.conditions.ids()) {
    for (const ProviderId causer : by_state[model.conditions[condition].state]) {
      if (model.causes(causer, condition)) out[condition].push_back(causer);
    }
  }
  return out;
}

PushGoals find_push_goals(const Model& model, const Facts& facts, const Chains& chains, const Causers& causers,
                          GroupId waiter) {
  return GoalSearch(model, facts, chains, causers, waiter).run();
}

std::vector<std::pair<ProviderId, ConditionUse>> waited_conditions(const Model& model, const Facts& facts,
                                                                   GroupId waiter) {
  std::vector<std::pair<ProviderId, ConditionUse>> out;
  for (const ProviderId id : providers_of_plans(model, facts, waiter)) {
    for (const ConditionUse& use : model.providers[id].when) out.emplace_back(id, use);
  }
  return out;
}

} // namespace director::checks
