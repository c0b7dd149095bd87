// Header: compiler/analysis/causing/promises.hpp. Test: compiler/checks/unreachable_causing.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/promises.hpp"

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/facts/pushes.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/graph/algorithms.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace director::analysis {

namespace {

/// The blame: from each provider that never runs to those that could remove the reason.
class BlameGraph {
public:
  BlameGraph(const Model& model, const Facts& facts, const Chains& chains)
      : model_(model),
        facts_(facts),
        causers_(find_causers(model)),
        sources_(find_sources(model)),
        arrows_(model.providers.size()) {
    for (const ProviderId id : model_.providers.ids()) {
      if (!facts_.active.contains(id)) arrows_[id.value] = find_blamed(id);
    }
    find_unpushed(chains);
  }

  bool is_idle(ProviderId id) const { return !facts_.active.contains(id); }
  const Arrows& arrows() const { return arrows_; }

  /// Conditions of a provider that never hold, unless they are reported as impossible.
  std::vector<ConditionUse> unmet(ProviderId id) const {
    std::vector<ConditionUse> out;
    for (const ConditionUse& use : model_.providers[id].when) {
      if (!facts_.may_hold(model_, id, use)) out.push_back(use);
    }
    return out;
  }

private:
  static void add(std::vector<Node>& row, ProviderId id) {
    if (std::find(row.begin(), row.end(), id.value) == row.end()) row.push_back(id.value);
  }

  std::vector<Node> find_blamed(ProviderId id) const {
    std::vector<Node> out;
    const Provider& provider = model_.providers[id];
    if (!facts_.requested.contains(provider.group)) {
      for (const ProviderId requester : requesters(provider.group)) add(out, requester);
    }
    for (const ConditionUse& use : unmet(id)) {
      for (const ProviderId setter : setters(use)) add(out, setter);
    }
    for (const Use<GroupId>& need : provider.needs) {
      if (facts_.capable_groups.contains(need.id)) continue;
      for (const ProviderId below : model_.groups[need.id].providers) add(out, below);
    }
    return out;
  }

  /// Blames, for a capable provider that is never pushed, what the waiting providers lack besides.
  void find_unpushed(const Chains& chains) {
    Pushes pushes(model_, facts_, chains, causers_);
    for (const GroupId waiter : model_.groups.ids()) {
      if (!facts_.requested.contains(waiter)) continue;
      PushSearch search(pushes, waiter);
      for (const auto& [provider, use] : waited_conditions(model_, facts_, waiter)) {
        for (const ProviderId causer : causers_[use.id]) {
          if (!is_idle(causer) || !facts_.capable.contains(causer)) continue;
          if (!search.beats(model_.providers[causer].group)) continue;
          for (const ConditionUse& other : unmet(provider)) {
            if (search.is_servable(other.id)) continue;
            for (const ProviderId setter : setters(other)) {
              if (setter != causer) add(arrows_[causer.value], setter);
            }
          }
        }
      }
    }
  }

  std::vector<ProviderId> requesters(GroupId group) const {
    std::vector<ProviderId> out;
    for (const EdgeId edge : model_.groups[group].requesters) {
      const std::optional<GroupId> requester = model_.edges[edge].requester;
      if (!requester) continue;
      for (const ProviderId id : model_.groups[*requester].providers) {
        for (const Pack& pack : model_.providers[id].packs) {
          if (std::any_of(pack.tasks.begin(), pack.tasks.end(),
                          [&](const Task& task) { return task.target == group; })) {
            out.push_back(id);
            break;
          }
        }
      }
    }
    return out;
  }

  /// Providers that would set the state to a value that the condition accepts.
  std::vector<ProviderId> setters(const ConditionUse& use) const {
    const Condition& condition = model_.conditions[use.id];
    std::vector<ProviderId> out;
    for (const Source& source : sources_[condition.state]) {
      if (!source.values.overlaps(condition.accepts)) continue;
      if (source.provider) out.push_back(*source.provider);
      if (source.group) {
        const std::vector<ProviderId>& all = model_.groups[*source.group].providers;
        out.insert(out.end(), all.begin(), all.end());
      }
    }
    return out;
  }

  const Model& model_;
  const Facts& facts_;
  Causers causers_;
  IdTable<StateId, std::vector<Source>> sources_;
  Arrows arrows_;
};

using Waiter = NeverKept::Waiting;

class PromiseSearch {
public:
  PromiseSearch(const Model& model, const Graph& graph, const Facts& facts, const Chains& chains)
      : model_(model),
        graph_(graph),
        facts_(facts),
        sources_(find_sources(model)),
        blame_(model, facts, chains),
        candidate_(model.providers.size(), false),
        arrows_of_(model.providers.size()) {
    for (const Graph::Causing& arrow : graph.causing) arrows_of_[arrow.causer].push_back(&arrow);
  }

  Promises run() {
    find_relevant();
    Promises out;
    std::vector<Node> explained;
    for (const std::vector<Node>& cycle : lowest_cycles(candidate_)) {
      explained.insert(explained.end(), cycle.begin(), cycle.end());
      NeverKept promise = make(ProviderId{cycle.front()});
      if (promise.pushable || !is_waited_for_as_is(promise.causer)) out.never_kept.push_back(std::move(promise));
    }
    out.explained = explained_by(explained);
    find_lost(out);
    out.never_run = find_never_run(out.explained);
    return out;
  }

private:
  /// Finds the awaited providers whose group is requested (or held for a requested one), and everything they are blamed
  /// on.
  void find_relevant() {
    relevant_ = IdSet<ProviderId>(model_.providers.size());
    std::vector<ProviderId> open;
    for (const GroupId group : model_.groups.ids()) {
      if (!facts_.requested.contains(group)) continue;
      for (const auto& [provider, use] : waited_conditions(model_, facts_, group)) {
        if (!facts_.may_hold(model_, provider, use)) open.push_back(provider);
      }
    }
    while (!open.empty()) {
      const ProviderId id = open.back();
      open.pop_back();
      if (!relevant_.add(id)) continue;
      for (const Node next : blame_.arrows()[id.value]) {
        if (blame_.is_idle(ProviderId{next})) open.push_back(ProviderId{next});
      }
    }
    for (const Graph::Causing& arrow : graph_.causing) {
      if (relevant_.contains(arrow.waiter) && blame_.is_idle(arrow.causer) &&
          !facts_.may_hold(model_, arrow.waiter, arrow.condition))
        candidate_[arrow.causer.value] = true;
    }
  }

  /// The relevant providers that are blamed on these or the other way round: the findings about these explain them.
  IdSet<ProviderId> explained_by(const std::vector<Node>& explained) const {
    Arrows back(model_.providers.size()), there(model_.providers.size());
    for (const ProviderId id : model_.providers.ids()) {
      for (const Node next : blame_.arrows()[id.value]) {
        if (!relevant_.contains(id) || !relevant_.contains(ProviderId{next})) continue;
        there[id.value].push_back(next);
        back[next].push_back(id.value);
      }
    }
    IdSet<ProviderId> out(model_.providers.size());
    for (const Node id : explained) out.add(ProviderId{id});
    for (const Arrows* arrows : {&there, &back}) {
      const std::vector<bool> reached = reachable(*arrows, explained);
      for (const ProviderId id : model_.providers.ids()) {
        if (reached[id.value]) out.add(id);
      }
    }
    return out;
  }

  /// A condition that holds at the start, that something can make false, and that only a provider can make true again
  /// which could run but is neither chosen nor pushed.
  void find_lost(Promises& out) const {
    IdTable<StateId, ValueSet> later(model_.states.size());
    for (const StateId state : model_.states.ids()) {
      for (const Source& source : sources_[state]) {
        if (source.kind != Source::Kind::initial || model_.states[state].of)
          later[state] = later[state].united(acts(model_, source, facts_.active) ? source.values : ValueSet{});
      }
    }
    std::map<ProviderId, NeverKept> lost;
    analysis::Waiting waits(model_, facts_);
    for (const GroupId group : model_.groups.ids()) {
      if (!facts_.requested.contains(group) || !waits.may_wait(group)) continue;
      for (const auto& [waiter, use] : waited_conditions(model_, facts_, group)) {
        const Condition& condition = model_.conditions[use.id];
        const State& state = model_.states[condition.state];
        if (!state.initial || !condition.accepts.contains(*state.initial) || !facts_.capable.contains(waiter)) continue;
        if (!waits.may_be_first(waiter)) continue;
        if (later[condition.state].subset_of(condition.accepts) && !(state.expires && !state.expires->to)) continue;
        if (later[condition.state].overlaps(condition.accepts)) continue;
        for (const Graph::Causing& arrow : graph_.causing) {
          if (arrow.waiter != waiter || arrow.condition.id != use.id || !is_passed_over(arrow.causer, waiter)) continue;
          NeverKept& row = lost[arrow.causer];
          if (row.waiting.empty()) row = {arrow.causer, arrow.promise, false, true, {}};
          if (std::none_of(row.waiting.begin(), row.waiting.end(),
                           [&](const Waiter& each) { return each.condition.span == use.span; }))
            row.waiting.push_back({waiter, use});
        }
      }
    }
    for (auto& [causer, row] : lost) {
      if (out.explained.contains(causer)) continue;
      out.explained.add(causer);
      for (const Waiter& each : row.waiting) out.explained.add(each.provider);
      if (!is_waited_for_as_is(causer)) out.never_kept.push_back(std::move(row));
    }
    std::stable_sort(out.never_kept.begin(), out.never_kept.end(),
                     [](const NeverKept& a, const NeverKept& b) { return a.causer < b.causer; });
  }

  bool is_passed_over(ProviderId causer, ProviderId waiter) const {
    const GroupId group = model_.providers[causer].group;
    return group != model_.providers[waiter].group && facts_.requested.contains(group) &&
           facts_.capable.contains(causer) && !facts_.excluded.contains(causer) && blame_.is_idle(causer);
  }

  /// The lowest of those that can never run for a reason that no other finding reports. If no provider of a requested
  /// group can run, that is reported for the group, and explains everything above it.
  std::vector<ProviderId> find_never_run(const IdSet<ProviderId>& explained) const {
    std::vector<bool> idle(model_.providers.size(), false);
    for (const ProviderId id : model_.providers.ids()) {
      const auto faults = facts_.impossible_of(id);
      idle[id.value] = facts_.requested.contains(model_.providers[id].group) && !facts_.capable.contains(id) &&
                       !explained.contains(id) && facts_.plans[id] == PlanVerdict::found &&
                       std::all_of(faults.begin(), faults.end(), [](const Impossible& fault) { return fault.stay; });
    }
    std::vector<ProviderId> out;
    for (const std::vector<Node>& cycle : lowest_cycles(idle)) {
      const auto at = std::find_if(cycle.begin(), cycle.end(), [&](Node node) {
        return facts_.capable_groups.contains(model_.providers[ProviderId{node}].group);
      });
      if (at != cycle.end()) out.push_back(ProviderId{*at});
    }
    return out;
  }

  /// Candidates that blame each other and no other candidate: each cycle sorted, in order of the first.
  std::vector<std::vector<Node>> lowest_cycles(const std::vector<bool>& candidate) const {
    const std::size_t size = model_.providers.size();
    std::vector<Node> cycle_of(size);
    std::vector<std::vector<Node>> members(size);
    for (Node node = 0; node < size; ++node) cycle_of[node] = node;
    for (const std::vector<Node>& cycle : cycles(blame_.arrows())) {
      for (const Node node : cycle) cycle_of[node] = cycle.front();
    }
    for (Node node = 0; node < size; ++node) {
      if (candidate[node]) members[cycle_of[node]].push_back(node);
    }
    // From the bottom up; in this order the members of a cycle are adjacent.
    std::vector<bool> blames(size, false); // a cycle: another one with candidates, directly or not
    const std::vector<Node> order = topological_order(blame_.arrows());
    for (auto node = order.rbegin(); node != order.rend(); ++node) {
      for (const Node next : blame_.arrows()[*node]) {
        const Node here = cycle_of[*node], below = cycle_of[next];
        if (here != below && (blames[below] || !members[below].empty())) blames[here] = true;
      }
    }
    std::vector<std::vector<Node>> out;
    for (Node node = 0; node < size; ++node) {
      if (!members[node].empty() && !blames[node]) out.push_back(std::move(members[node]));
    }
    std::sort(out.begin(), out.end());
    return out;
  }

  /// Whether a provider with conditions reported as impossible waits for it: a task may wait for that one for ever, and
  /// push for it.
  bool is_waited_for_as_is(ProviderId causer) const {
    const std::vector<const Graph::Causing*>& all = arrows_of_[causer];
    return std::any_of(all.begin(), all.end(), [&](const Graph::Causing* arrow) {
      return !facts_.impossible_of(arrow->waiter).empty() &&
             facts_.requested.contains(model_.providers[arrow->waiter].group);
    });
  }

  NeverKept make(ProviderId causer) const {
    NeverKept out;
    out.causer = causer;
    out.pushable = !facts_.requested.contains(model_.providers[causer].group) || !facts_.capable.contains(causer) ||
                   facts_.excluded.contains(causer);
    std::set<ProviderId> seen{causer};
    std::vector<ProviderId> open{causer};
    for (std::size_t next = 0; next < open.size(); ++next) {
      for (const Graph::Causing* arrow : arrows_of_[open[next]]) {
        if (facts_.may_hold(model_, arrow->waiter, arrow->condition)) continue;
        if (out.waiting.empty()) out.promise = arrow->promise;
        if (arrow->waiter == causer || !seen.insert(arrow->waiter).second) continue;
        out.waiting.push_back({arrow->waiter, arrow->condition});
        open.push_back(arrow->waiter);
      }
    }
    return out;
  }

  const Model& model_;
  const Graph& graph_;
  const Facts& facts_;
  IdTable<StateId, std::vector<Source>> sources_;
  BlameGraph blame_;
  IdSet<ProviderId> relevant_;
  std::vector<bool> candidate_;
  IdTable<ProviderId, std::vector<const Graph::Causing*>> arrows_of_; ///< by causer
};

} // namespace

Promises find_promises(const Model& model, const Graph& graph, const Facts& facts, const Chains& chains) {
  return PromiseSearch(model, graph, facts, chains).run();
}

} // namespace director::analysis
