// Header: compiler/analysis/facts/contexts.hpp. Test: tests/compiler/analysis/facts/contexts_test.cpp.
// SPDX-License-Identifier: MIT
//
// A running provider may continue by its `stay`, and a pushed one without the conditions on what it causes itself; one
// that begins needs its `when`.
#include "compiler/analysis/facts/contexts.hpp"

#include "compiler/analysis/plans/choices.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace director::analysis {

namespace {

/// With more combinations than this one is assumed to be possible.
constexpr std::int64_t most_context_steps = 20'000;
/// In units of the run's budget: each pick copies a region.
constexpr std::int64_t context_step_cost = 20;

} // namespace

/// The current choice, with the region of its conditions.
class JointPlan {
public:
  JointPlan(const Contexts& contexts, Region within) : contexts_(contexts), now_(std::move(within)) {}

  bool pick(ProviderId provider) {
    const Facts& facts = contexts_.facts_;
    if (!facts.capable.contains(provider)) return false;
    const Provider& row = contexts_.model_.providers[provider];
    before_.emplace_back();
    if (row.when.empty() && row.stay.empty()) return true;
    Region both = now_;
    both.meet(contexts_.around(provider));
    if (!contexts_.may_be(both)) return before_.pop_back(), false;
    before_.back() = std::exchange(now_, std::move(both));
    return true;
  }
  void drop() {
    if (before_.back()) now_ = std::move(*before_.back());
    before_.pop_back();
  }
  void dead_end() const {}
  /// A provider without a plan is reported by another check; here it is assumed to need nothing.
  bool leave_needs(ProviderId provider) const { return contexts_.facts_.plans[provider] != PlanVerdict::found; }
  bool complete() {
    found_ = true;
    return false;
  }
  bool found() const { return found_; }

private:
  const Contexts& contexts_;
  Region now_;
  std::vector<std::optional<Region>> before_; ///< for each pick; empty: it changed nothing
  bool found_ = false;
};

Contexts::Contexts(const Model& model, Facts& facts) : model_(model), facts_(facts) {
  facts.contexts = facts.grants = IdTable<GroupId, Region>(model.groups.size());
}

bool Contexts::widen(GroupId group, const Requested& requested) {
  if (facts_.requested.add(group)) {
    facts_.contexts[group] = requested.tried;
    facts_.grants[group] = requested.granted;
    return true;
  }
  const auto widen = [](Region& here, const Region& region) {
    Region both = hull(here, region);
    if (both.states == here.states) return false;
    here = std::move(both);
    return true;
  };
  const bool tried = widen(facts_.contexts[group], requested.tried);
  return widen(facts_.grants[group], requested.granted) || tried;
}

Region Contexts::around_requested(ProviderId id) {
  const GroupId group = model_.providers[id].group;
  Region out = around(id);
  // While its requester is stale, a task that runs goes on without those that it was granted together with.
  const Region& granted = facts_.grants[group];
  out.meet(may_be_in_limbo(group) ? after(granted) : kept_within(facts_.contexts[group], granted));
  if (facts_.plans[id] == PlanVerdict::found) {
    for (const Use<GroupId>& need : model_.providers[id].needs) out.meet(around_needed(need.id));
  }
  return out;
}

void Contexts::visit_below(GroupId group, const std::function<void(GroupId, const Requested&)>& visitor) {
  std::size_t running = 0;
  Requested anywhere;
  std::map<GroupId, Requested> requested;
  for (const ProviderId id : model_.groups[group].providers) {
    if (!facts_.active.contains(id)) continue;
    const Region region = around_requested(id);
    anywhere.tried = running++ == 0 ? region : hull(anywhere.tried, region);
    for (const Pack& pack : model_.providers[id].packs) {
      Region whole = region;
      whole.meet(around_members(pack));
      for (const Task& task : pack.tasks) {
        const Requested here{region, is_always_member(pack, task) ? whole : region};
        const auto [at, is_new] = requested.try_emplace(task.target, here);
        Requested& all = at->second;
        if (!is_new) all = {hull(all.tried, here.tried), hull(all.granted, here.granted)};
      }
    }
  }
  for (auto& [target, all] : requested) {
    // Another provider of the group may keep the request of the one that ran before, even if it requests the same
    // itself.
    if (running > 1) {
      all.tried = kept_within(anywhere.tried, all.tried);
      all.granted = kept_within(anywhere.tried, all.granted);
    }
    visitor(target, all);
  }
}

Region Contexts::after(const Region& region) const {
  Region out;
  for (const auto& [id, values] : region.states) {
    const State& state = model_.states[id];
    if (!state.expires || state.expires->to) out.states.emplace(id, values.united(facts_.given[id]));
  }
  return out;
}

Region Contexts::kept_within(const Region& within, const Region& region) const {
  Region later = after(region);
  later.meet(within);
  return hull(region, later);
}

bool Contexts::is_always_member(const Pack& pack, const Task& task) const {
  return !pack.name.empty() && model_.is_always_member(task);
}

const Region& Contexts::around_members(const Pack& pack) {
  const auto [at, is_new] = members_.try_emplace(&pack);
  if (!is_new) return at->second;
  for (const Task& task : pack.tasks) {
    if (is_always_member(pack, task) && facts_.may_wait.contains(task.target))
      at->second.meet(around_needed(task.target));
  }
  return at->second;
}

bool Contexts::may_be_in_limbo(GroupId group) const {
  const auto has_requester = [&](EdgeId id) { return model_.edges[id].requester.has_value(); };
  const std::vector<EdgeId>& above = model_.groups[group].requesters;
  return std::any_of(above.begin(), above.end(), [&](EdgeId id) {
    if (!model_.edges[id].requester || model_.edges[id].levels.empty()) return false;
    const std::vector<EdgeId>& next = model_.groups[*model_.edges[id].requester].requesters;
    // A task without conditions that only one group requests is granted as long as that group runs.
    return (next.size() > 1 || facts_.may_wait.contains(*model_.edges[id].requester)) &&
           std::any_of(next.begin(), next.end(), has_requester);
  });
}

bool Contexts::forget_needed() {
  const bool any = !needed_.empty();
  needed_.clear();
  members_.clear();
  return any;
}

const Region& Contexts::around_needed(GroupId group) {
  const auto [at, is_new] = needed_.try_emplace(group); // in a cycle of needs: anywhere
  if (!is_new || !facts_.may_wait.contains(group)) return at->second;
  std::optional<Region> out;
  for (const ProviderId id : model_.groups[group].providers) {
    Region region = around(id);
    if (facts_.plans[id] == PlanVerdict::found) {
      for (const Use<GroupId>& need : model_.providers[id].needs) region.meet(around_needed(need.id));
    }
    if (!region.empty()) out = out ? hull(*out, region) : region;
  }
  return needed_[group] = out.value_or(Region{});
}

Region Contexts::around(ProviderId id) const { return facts_.region_to_run(model_, id, facts_.pushed.contains(id)); }

bool Contexts::may_be(const Region& region) const {
  return std::all_of(region.states.begin(), region.states.end(),
                     [&](const auto& entry) { return entry.second.overlaps(facts_.values[entry.first]); });
}

bool Contexts::can_begin(ProviderId id, Region within) {
  within.meet(facts_.region_to_begin(model_, id));
  return has_choice(id, std::move(within));
}

bool Contexts::can_go_on(ProviderId id, Region within) {
  within.meet(around(id));
  return has_choice(id, std::move(within));
}

/// Whether none of its possible needs has a condition, or can never run: then any plan is possible.
bool Contexts::always_has_needs(const Provider& provider) const {
  IdSet<GroupId> seen(model_.groups.size());
  std::vector<const Provider*> open{&provider};
  while (!open.empty()) {
    const Provider& now = *open.back();
    open.pop_back();
    for (const Use<GroupId>& need : now.needs) {
      if (facts_.may_wait.contains(need.id)) return false;
      if (!seen.add(need.id)) continue;
      for (const ProviderId each : model_.groups[need.id].providers) {
        if (!facts_.capable.contains(each)) return false;
        open.push_back(&model_.providers[each]);
      }
    }
  }
  return true;
}

bool Contexts::has_choice(ProviderId id, Region within) {
  if (!may_be(within)) return false;
  const Provider& provider = model_.providers[id];
  // Needs without a possible plan are reported by another check; elsewhere they are treated as corrected.
  if (provider.needs.empty() || facts_.plans[id] != PlanVerdict::found || always_has_needs(provider)) return true;
  JointPlan plan(*this, std::move(within));
  const std::int64_t granted = facts_.budget.grant(most_context_steps * context_step_cost) / context_step_cost;
  ChoiceSearch search(model_, granted, plan);
  search.hold(provider.group);
  const bool complete = search.run(provider.needs);
  facts_.budget.spend((granted - search.steps_left()) * context_step_cost);
  return plan.found() || !complete;
}

} // namespace director::analysis
