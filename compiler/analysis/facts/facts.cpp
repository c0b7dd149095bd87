// Header: compiler/analysis/facts/facts.hpp. Test: tests/compiler/analysis/facts/facts_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/facts/facts.hpp"

#include "compiler/analysis/chains/meetings.hpp"
#include "compiler/analysis/facts/contexts.hpp"
#include "compiler/analysis/facts/pushes.hpp"
#include "compiler/analysis/states/choice.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/states/sources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace director::analysis {

namespace {

class FactFinder {
public:
  FactFinder(const Model& model, const Graph& graph, Reported reported, Enabled enabled)
      : model_(model),
        graph_(graph),
        reported_(reported),
        enabled_(enabled),
        sources_(find_sources(model)),
        causers_(find_causers(model)),
        rivals_(model, facts_.holding, facts_.active),
        contexts_(model, facts_) {
    const std::size_t groups = model.groups.size(), providers = model.providers.size();
    facts_.declared = facts_.values = facts_.given = IdTable<StateId, ValueSet>(model.states.size());
    facts_.plans = IdTable<ProviderId, PlanVerdict>(providers, PlanVerdict::found);
    facts_.capable_groups = facts_.requested = planned_ = IdSet<GroupId>(groups);
    facts_.holding = IdSet<EdgeId>(model.edges.size());
    needers_ = IdTable<GroupId, std::vector<GroupId>>(groups);
    waiters_ = IdTable<StateId, std::vector<GroupId>>(model.states.size());
    followers_ = IdTable<StateId, std::set<GroupId>>(model.states.size());
    set_by_provider_ = IdTable<ProviderId, Sets>(providers);
    set_by_handlers_ = IdTable<GroupId, Sets>(groups);
    place_ = IdTable<GroupId, std::size_t>(groups);
    facts_.capable = facts_.chosen = facts_.pushed = facts_.active = facts_.excluded = IdSet<ProviderId>(providers);
  }

  Facts run() {
    find_declared();
    find_concerned();
    find_waiting();
    for (const ProviderId id : model_.providers.ids()) {
      facts_.plans[id] = find_plan(model_, id, facts_.budget);
      if (reported_ == Reported::as_is) continue;
      find_impossible(id, false);
      find_impossible(id, true);
    }
    for (const Task& root : model_.roots) {
      hold(root.edge);
      request(root.target, {});
    }
    for (const StateId state : model_.states.ids()) {
      for (const Source& source : sources_[state]) {
        if (source.provider || source.group || source.kind == Source::Kind::expires) continue;
        grow(state, source.values, source.kind != Source::Kind::initial || model_.states[state].of.has_value());
      }
    }
    for (const GroupId group : model_.groups.ids()) look_again(group);
    do {
      if (contexts_.forget_needed()) {
        for (const GroupId group : model_.groups.ids()) look_again(group);
      }
      // Pushes take the longest: they are searched only when everything else is stable.
      settle_all();
      changed_ = false;
      find_pushed();
    } while (changed_ || (news_ != news_then_ && !together_.empty()));
    for (const ProviderId id : model_.providers.ids()) {
      const GroupId group = model_.providers[id].group;
      if (facts_.requested.contains(group) && facts_.capable.contains(id) && !facts_.active.contains(id) &&
          !contexts_.can_begin(id, facts_.grants[group]))
        facts_.excluded.add(id);
    }
    for (const GroupId group : model_.groups.ids()) {
      contexts_.visit_below(
          group, [&](GroupId target, const Contexts::Requested& requested) { exclude(group, target, requested); });
    }
    std::sort(facts_.excluded_tasks.begin(), facts_.excluded_tasks.end());
    return std::move(facts_);
  }

private:
  /// The target runs for others, but its providers never can where this group requests it.
  void exclude(GroupId requester, GroupId target, const Contexts::Requested& requested) {
    const std::vector<ProviderId>& all = model_.groups[target].providers;
    const auto runs = [&](ProviderId each) { return facts_.active.contains(each); };
    if (requested.granted.states.empty() || std::none_of(all.begin(), all.end(), runs) ||
        std::any_of(all.begin(), all.end(), [&](ProviderId each) {
          return facts_.capable.contains(each) && contexts_.can_go_on(each, requested.granted);
        }))
      return;
    for (const EdgeId id : model_.groups[target].requesters) {
      if (model_.edges[id].requester == requester && !model_.edges[id].levels.empty())
        facts_.excluded_tasks.push_back(id);
    }
  }

  void find_declared() {
    for (const StateId state : model_.states.ids()) {
      for (const Source& source : sources_[state])
        facts_.declared[state] = facts_.declared[state].united(source.values);
    }
  }

  /// Finds the groups that a new fact may concern.
  void find_concerned() {
    for (const GroupId group : model_.groups.ids()) {
      for (const ProviderId id : model_.groups[group].providers) {
        for (const Use<GroupId>& need : model_.providers[id].needs) needers_[need.id].push_back(group);
        for (const ConditionUse& use : model_.providers[id].when) {
          std::vector<GroupId>& waiters = waiters_[model_.conditions[use.id].state];
          if (waiters.empty() || waiters.back() != group) waiters.push_back(group);
        }
      }
    }
    for (const StateId state : model_.states.ids()) {
      for (const Source& source : sources_[state]) {
        if (source.provider) set_by_provider_[*source.provider].emplace_back(state, &source);
        if (source.group) set_by_handlers_[*source.group].emplace_back(state, &source);
      }
    }
    for (std::size_t place = 0; place < graph_.order.size(); ++place) place_[GroupId{graph_.order[place]}] = place;
  }

  /// From each group with a condition up to all that may need it.
  void find_waiting() {
    std::vector<GroupId> open;
    for (const Provider& provider : model_.providers) {
      if (!provider.when.empty()) open.push_back(provider.group);
    }
    facts_.may_wait = IdSet<GroupId>(model_.groups.size());
    while (!open.empty()) {
      const GroupId group = open.back();
      open.pop_back();
      if (facts_.may_wait.add(group)) open.insert(open.end(), needers_[group].begin(), needers_[group].end());
    }
  }

  void find_impossible(ProviderId id, bool stay) {
    const Provider& provider = model_.providers[id];
    const std::vector<ConditionUse>& conditions = stay ? provider.stay : provider.when;
    for (const auto& [state, accepted] : region_of(model_, conditions).states) {
      Impossible fault{id, stay, state, Impossible::Why::contradictory, {}};
      if (!accepted.empty()) {
        if (accepted.overlaps(facts_.declared[state])) continue;
        fault.why = sources_[state].empty() ? Impossible::Why::without_source : Impossible::Why::unreachable;
      }
      for (const ConditionUse& use : conditions) {
        if (model_.conditions[use.id].state == state) fault.uses.push_back(use);
      }
      facts_.impossible.push_back(std::move(fault));
    }
  }

  /// Derives everything that follows without a push. Each round examines what the one before changed: requesters come
  /// before what they request, so there are few rounds; but a chain of causes takes as many as it has links.
  void settle() {
    while (!again_.empty()) {
      std::vector<GroupId> groups = std::move(again_);
      again_.clear();
      for (const GroupId group : groups) waits_for_a_look_.remove(group);
      std::sort(groups.begin(), groups.end(), [&](GroupId a, GroupId b) { return place_[a] < place_[b]; });
      // Needed groups come last in the graph's order, but their capability first.
      for (auto group = groups.rbegin(); group != groups.rend(); ++group) find_capable(*group);
      for (const GroupId group : groups) find_active(group);
    }
  }

  /// Also for conditions of several groups together that failed, until the result is stable.
  void settle_all() {
    settle();
    while (news_ != news_then_ && !together_.empty()) {
      news_then_ = news_;
      for (const GroupId group : std::exchange(together_, {})) look_again(group);
      settle();
    }
  }

  void hold(EdgeId edge) {
    if (facts_.holding.add(edge)) ++news_;
  }

  /// Records everything that its plans may hold.
  void hold_needs(ProviderId provider) {
    std::vector<ProviderId> open{provider};
    while (!open.empty()) {
      const ProviderId id = open.back();
      open.pop_back();
      if (!holds_needs_.add(id)) continue;
      const GroupId group = model_.providers[id].group;
      for (const Use<GroupId>& need : model_.providers[id].needs) {
        for (const EdgeId edge : model_.groups[group].edges) {
          if (model_.edges[edge].target == need.id) hold(edge);
        }
        if (!planned_.add(need.id)) continue;
        for (const ProviderId below : model_.groups[need.id].providers) {
          if (facts_.capable.contains(below)) open.push_back(below);
        }
      }
    }
  }

  void request(GroupId group, const Contexts::Requested& requested) {
    if (!contexts_.widen(group, requested)) return;
    ++news_;
    look_again(group);
  }

  void look_again(GroupId group) {
    if (waits_for_a_look_.add(group)) again_.push_back(group);
  }

  /// `again`: not only at the start. A state that has a value may expire.
  void grow(StateId state, const ValueSet& values, bool again) {
    grow_by(state, values, again);
    const State& row = model_.states[state];
    if (row.expires && row.expires->to) grow_by(state, ValueSet::single(*row.expires->to), true);
  }

  void grow_by(StateId state, const ValueSet& values, bool again) {
    if (again && !values.subset_of(facts_.given[state])) {
      facts_.given[state] = facts_.given[state].united(values);
      ++news_;
      for (const GroupId group : followers_[state]) look_again(group);
    }
    ValueSet more = facts_.values[state].united(values);
    if (more == facts_.values[state]) return;
    facts_.values[state] = std::move(more);
    ++news_;
    for (const GroupId group : waiters_[state]) look_again(group);
  }

  void find_capable(GroupId group) {
    for (const ProviderId id : model_.groups[group].providers) {
      if (facts_.capable.contains(id)) continue;
      const Provider& provider = model_.providers[id];
      if (!conditions_may_hold(id)) continue;
      // Needs without a possible plan are reported by another check; elsewhere they are treated as corrected.
      if (reported_ == Reported::as_is && facts_.plans[id] == PlanVerdict::none) continue;
      const bool has_needs = facts_.plans[id] != PlanVerdict::found ||
                             std::all_of(provider.needs.begin(), provider.needs.end(), [&](const Use<GroupId>& need) {
                               return facts_.capable_groups.contains(need.id);
                             });
      if (!has_needs) continue;
      if (!contexts_.can_begin(id, Region{})) {
        together_.push_back(group);
        continue;
      }
      facts_.capable.add(id);
      ++news_;
      if (planned_.contains(group)) hold_needs(id);
      if (!facts_.capable_groups.add(group)) continue;
      for (const GroupId needer : needers_[group]) look_again(needer);
    }
  }

  bool conditions_may_hold(ProviderId id) const {
    const Region region = region_of(model_, model_.providers[id].when);
    return std::all_of(region.states.begin(), region.states.end(), [&](const auto& entry) {
      return entry.second.overlaps(facts_.values[entry.first]) || facts_.is_impossible(id, entry.first);
    });
  }

  std::vector<StateId> corrected_states(ProviderId id) const {
    std::vector<StateId> out;
    for (const Impossible& fault : facts_.impossible_of(id)) {
      if (!fault.stay) out.push_back(fault.state);
    }
    return out;
  }

  /// Whether its `when` may hold while each of its rivals lacks something. Rivals that exclude it lack it then.
  bool may_come_first(ProviderId id) {
    if (enabled_ == Enabled::some) return true;
    const GroupId group = model_.providers[id].group;
    Region own = facts_.region_to_begin(model_, id);
    own.meet(facts_.grants[group]);
    std::vector<Region> others;
    bool with_needs = false; // which others may come to hold later
    const auto counts = [&](const Rival& rival) {
      return facts_.plans[rival.provider] == PlanVerdict::found && corrected_states(rival.provider).empty();
    };
    for (const Rival& rival : rivals_.that_meet(id, own, counts)) {
      with_needs = with_needs || !model_.providers[rival.provider].needs.empty();
      if (counts(rival)) others.insert(others.end(), rival.ways.begin(), rival.ways.end());
    }
    const Covering covering = find_covering(model_, own, others, facts_.values, facts_.budget);
    if (covering == Covering::undecided)
      facts_.budget.leave_open(model_.providers[id].span,
                               fmt::format("whether `{}` ever comes first", model_.full_name(id)));
    if (covering == Covering::covered && with_needs) together_.push_back(group);
    return covering != Covering::covered;
  }

  void find_active(GroupId group) {
    if (!facts_.requested.contains(group)) return;
    for (const ProviderId id : model_.groups[group].providers) {
      if (!facts_.capable.contains(id) || facts_.chosen.contains(id)) continue;
      if (!contexts_.can_begin(id, facts_.grants[group])) {
        if (!facts_.active.contains(id)) together_.push_back(group);
        continue;
      }
      if (may_come_first(id)) facts_.chosen.add(id);
      if (!facts_.active.contains(id) && (facts_.chosen.contains(id) || facts_.pushed.contains(id)))
        become_active(group, id);
    }
    request_below(group);
  }

  /// What one of its providers requests remains while any of them runs.
  void request_below(GroupId group) {
    contexts_.visit_below(group, [&](GroupId target, const Contexts::Requested& requested) {
      for (const auto& entry : requested.granted.states) followers_[entry.first].insert(group);
      request(target, requested);
    });
  }

  void become_active(GroupId group, ProviderId id) {
    facts_.active.add(id);
    hold_needs(id);
    for (const Pack& pack : model_.providers[id].packs) {
      for (const Task& task : pack.tasks) hold(task.edge);
    }
    changed_ = true;
    ++news_;
    for (const auto& [state, source] : set_by_provider_[id]) grow(state, source->values, true);
    for (const auto& [state, source] : set_by_handlers_[group]) grow(state, source->values, true);
  }

  /// The consequences of a push are derived at once, so that tasks behind it need not search the whole chain again.
  void find_pushed() {
    const Chains chains(model_, [&](ProviderId id) { return facts_.active.contains(id); });
    Pushes pushes(model_, facts_, chains, causers_);
    Explored explored(model_);
    for (const GroupId waiter : model_.groups.ids()) {
      if (!facts_.requested.contains(waiter)) continue;
      for (const ProviderId id : PushSearch(pushes, waiter).explore(explored)) {
        if (!facts_.pushed.add(id)) continue;
        changed_ = true;
        ++news_;
        look_again(model_.providers[id].group);
      }
      settle();
    }
  }

  const Model& model_;
  const Graph& graph_;
  Reported reported_;
  Enabled enabled_;
  IdTable<StateId, std::vector<Source>> sources_;
  Causers causers_;
  Rivals rivals_;
  IdTable<GroupId, std::vector<GroupId>> needers_;
  IdTable<StateId, std::vector<GroupId>> waiters_;
  IdTable<StateId, std::set<GroupId>> followers_; ///< whose requests remain after the values with which they were made
  using Sets = std::vector<std::pair<StateId, const Source*>>;
  IdTable<ProviderId, Sets> set_by_provider_;
  IdTable<GroupId, Sets> set_by_handlers_;
  IdTable<GroupId, std::size_t> place_; ///< in the graph's order
  std::vector<GroupId> again_;          ///< that a new fact concerns
  SparseSet<GroupId> waits_for_a_look_; ///< ... each once
  IdSet<GroupId> planned_;              ///< needed by a plan of a provider that may be active
  SparseSet<ProviderId> holds_needs_;
  std::vector<GroupId> together_;        ///< with a provider that may run, depending on what other groups cause
  std::size_t news_ = 0, news_then_ = 0; ///< number of facts, now and when that was last examined
  Facts facts_;
  Contexts contexts_;
  bool changed_ = false;
};

} // namespace

std::span<const Impossible> Facts::impossible_of(ProviderId provider) const {
  const auto [first, last] =
      std::equal_range(impossible.begin(), impossible.end(), Impossible{provider, false, {}, {}, {}},
                       [](const Impossible& a, const Impossible& b) { return a.provider < b.provider; });
  return {first, last};
}

Region Facts::region_to_begin(const Model& model, ProviderId provider) const {
  Region out = region_of(model, model.providers[provider].when);
  for (const Impossible& fault : impossible_of(provider)) {
    if (!fault.stay) out.states.erase(fault.state);
  }
  return out;
}

Region Facts::region_to_run(const Model& model, ProviderId provider, bool pushed) const {
  Region out = active_region(model, model.providers[provider]);
  for (const Impossible& fault : impossible_of(provider)) out.states.erase(fault.state);
  if (pushed) {
    for (const ConditionUse& promise : model.providers[provider].causing)
      out.states.erase(model.conditions[promise.id].state);
  }
  return out;
}

bool Facts::is_impossible(ProviderId provider, StateId state) const {
  const std::span<const Impossible> faults = impossible_of(provider);
  return std::any_of(faults.begin(), faults.end(),
                     [&](const Impossible& fault) { return !fault.stay && fault.state == state; });
}

bool Facts::may_hold(const Model& model, ProviderId provider, const ConditionUse& use) const {
  const Condition& condition = model.conditions[use.id];
  return is_impossible(provider, condition.state) || values[condition.state].overlaps(condition.accepts);
}

bool Facts::holds_always(const Model& model, ConditionId id, const Region& region) const {
  const Condition& condition = model.conditions[id];
  const auto at = region.states.find(condition.state);
  if (at == region.states.end())
    return !model.states[condition.state].may_be_unset() && values[condition.state].subset_of(condition.accepts);
  return values[condition.state].intersected(at->second).subset_of(condition.accepts);
}

Facts find_facts(const Model& model, const Graph& graph, Reported reported, Enabled enabled) {
  return FactFinder(model, graph, reported, enabled).run();
}

} // namespace director::analysis
