// Header: compiler/analysis/facts/facts.hpp. Test: tests/compiler/analysis/facts/facts_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/chains/meetings.hpp"
#include "compiler/analysis/facts/concerned.hpp"
#include "compiler/analysis/facts/contexts.hpp"
#include "compiler/analysis/facts/excluded.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/facts/impossible.hpp"
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
        reported_(reported),
        enabled_(enabled),
        sources_(find_sources(model)),
        concerned_(find_concerned(model, graph, sources_)),
        causers_(find_causers(model)),
        rivals_(model, facts_.holding, facts_.active),
        contexts_(model, facts_) {
    const std::size_t groups = model.groups.size(), providers = model.providers.size();
    facts_.declared = find_declared(model, sources_);
    facts_.may_wait = find_waiting(model, concerned_);
    facts_.values = facts_.given = IdTable<StateId, ValueSet>(model.states.size());
    facts_.plans = IdTable<ProviderId, PlanVerdict>(providers, PlanVerdict::found);
    facts_.capable_groups = facts_.requested = planned_ = IdSet<GroupId>(groups);
    facts_.holding = IdSet<EdgeId>(model.edges.size());
    followers_ = IdTable<StateId, std::set<GroupId>>(model.states.size());
    facts_.capable = facts_.chosen = facts_.pushed = facts_.active = facts_.excluded = IdSet<ProviderId>(providers);
  }

  Facts run() {
    for (const ProviderId id : model_.providers.ids()) facts_.plans[id] = find_plan(model_, id, facts_.budget);
    if (reported_ != Reported::as_is) facts_.impossible = find_impossible(model_, sources_, facts_.declared);
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
    find_excluded(model_, contexts_, facts_);
    return std::move(facts_);
  }

private:
  /// Derives everything that follows without a push. Each round examines what the one before changed: requesters come
  /// before what they request, so there are few rounds; but a chain of causes takes as many as it has links.
  void settle() {
    while (!again_.empty()) {
      std::vector<GroupId> groups = std::move(again_);
      again_.clear();
      for (const GroupId group : groups) waits_for_a_look_.remove(group);
      std::sort(groups.begin(), groups.end(),
                [&](GroupId a, GroupId b) { return concerned_.place[a] < concerned_.place[b]; });
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
    for (const GroupId group : concerned_.waiters[state]) look_again(group);
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
      for (const GroupId needer : concerned_.needers[group]) look_again(needer);
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
    for (const auto& [state, source] : concerned_.set_by_provider[id]) grow(state, source->values, true);
    for (const auto& [state, source] : concerned_.set_by_handlers[group]) grow(state, source->values, true);
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
  Reported reported_;
  Enabled enabled_;
  IdTable<StateId, std::vector<Source>> sources_;
  const Concerned concerned_;
  Causers causers_;
  Rivals rivals_;
  IdTable<StateId, std::set<GroupId>> followers_; ///< whose requests remain after the values with which they were made
  std::vector<GroupId> again_;                    ///< that a new fact concerns
  SparseSet<GroupId> waits_for_a_look_;           ///< ... each once
  IdSet<GroupId> planned_;                        ///< needed by a plan of a provider that may be active
  SparseSet<ProviderId> holds_needs_;
  std::vector<GroupId> together_;        ///< with a provider that may run, depending on what other groups cause
  std::size_t news_ = 0, news_then_ = 0; ///< number of facts, now and when that was last examined
  Facts facts_;
  Contexts contexts_;
  bool changed_ = false;
};

} // namespace

Facts find_facts(const Model& model, const Graph& graph, Reported reported, Enabled enabled) {
  return FactFinder(model, graph, reported, enabled).run();
}

} // namespace director::analysis
