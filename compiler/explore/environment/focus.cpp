// Header: compiler/explore/environment/focus.hpp. Test: tests/compiler/explore/environment/focus_test.cpp.
// SPDX-License-Identifier: MIT
//
// The plan assumes that nothing is ever lost again once it is reached: the cheapest way to run a provider is the
// cheapest request of its group and, for each of its conditions, the cheapest way to make it true. Costs are relaxed in
// rounds until none changes (Bellman and Ford), then the plan is read backwards from the goal.
#include "compiler/explore/environment/focus.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace director::compiler {

namespace {

constexpr std::uint32_t never = std::numeric_limits<std::uint32_t>::max() / 4;
std::uint32_t sum(std::uint32_t a, std::uint32_t b) { return std::min(a + b, never); }

/// How something comes about: its cheapest cause inside the behaviour, if it needs one, and the cost.
struct Coming {
  std::uint32_t cost = never;
  std::optional<ProviderId> by;
  bool outside = false; ///< the program requests it, or sets it
};

class Planner {
public:
  explicit Planner(const Model& model)
      : model_(model),
        conditions_(model.conditions.size()),
        providers_(model.providers.size(), never),
        edges_(model.edges.size()),
        requesters_(model.edges.size()),
        setters_(model.states.size()) {
    for (const ProviderId id : model.providers.ids()) {
      const Provider& provider = model.providers[id];
      for (const Pack& pack : provider.packs) {
        for (const Task& task : pack.tasks) requesters_[task.edge].push_back(id);
      }
      for (const auto* uses : {&provider.causing, &provider.sets}) set_by(id, *uses);
    }
    for (const Group& group : model.groups) {
      for (const auto* handler : {&group.start, &group.stop}) {
        if (*handler) set_by(group.providers.front(), (*handler)->sets);
      }
    }
    for (const Task& root : model.roots) edges_[root.edge] = {1, {}, true};
    for (const ConditionId id : model.conditions.ids()) conditions_[id] = from_outside(model.conditions[id]);
    while (relax()) {}
  }

  std::uint32_t cost(ProviderId id) const { return providers_[id]; }
  std::optional<ProviderId> cheapest(GroupId group) const {
    std::optional<ProviderId> out;
    for (const ProviderId id : model_.groups[group].providers) {
      if (providers_[id] < never && (!out || providers_[id] < providers_[*out])) out = id;
    }
    return out;
  }
  const Coming& way(EdgeId id) const { return edges_[id]; }
  const Coming& way(ConditionId id) const { return conditions_[id]; }
  std::optional<EdgeId> request(GroupId group) const {
    std::optional<EdgeId> out;
    for (const EdgeId edge : model_.groups[group].requesters) {
      if (edges_[edge].cost < never && (!out || edges_[edge].cost < edges_[*out].cost)) out = edge;
    }
    return out;
  }

private:
  struct Setter {
    ProviderId by{};
    ConditionId what{};
  };

  void set_by(ProviderId id, const std::vector<ConditionUse>& uses) {
    for (const ConditionUse& use : uses) setters_[model_.conditions[use.id].state].push_back({id, use.id});
  }

  Coming from_outside(const Condition& condition) const {
    const State& state = model_.states[condition.state];
    if (state.initial && condition.accepts.contains(*state.initial)) return {0, {}, false};
    if (state.external && condition.accepts.overlaps(state.domain())) return {1, {}, true};
    if (state.expires && state.expires->to && condition.accepts.contains(*state.expires->to)) return {2, {}, true};
    return {};
  }

  std::uint32_t cost_of(const Provider& provider) const {
    const std::optional<EdgeId> edge = request(provider.group);
    std::uint32_t out = edge ? sum(1, edges_[*edge].cost) : never;
    for (const ConditionUse& use : provider.when) out = sum(out, conditions_[use.id].cost);
    return out;
  }

  static bool better(Coming& way, std::uint32_t cost, ProviderId by) {
    if (cost >= way.cost) return false;
    way = {cost, by, false};
    return true;
  }

  bool relax() {
    bool out = false;
    for (const ProviderId id : model_.providers.ids()) {
      const std::uint32_t cost = cost_of(model_.providers[id]);
      if (cost >= providers_[id]) continue;
      providers_[id] = cost;
      out = true;
    }
    for (const EdgeId id : model_.edges.ids()) {
      for (const ProviderId by : requesters_[id]) out = better(edges_[id], sum(providers_[by], 1), by) || out;
    }
    for (const ConditionId id : model_.conditions.ids()) {
      for (const Setter& setter : setters_[model_.conditions[id].state]) {
        if (!model_.conditions[setter.what].accepts.overlaps(model_.conditions[id].accepts)) continue;
        out = better(conditions_[id], sum(providers_[setter.by], 1), setter.by) || out;
      }
    }
    return out;
  }

  const Model& model_;
  IdTable<ConditionId, Coming> conditions_;
  IdTable<ProviderId, std::uint32_t> providers_;
  IdTable<EdgeId, Coming> edges_;
  IdTable<EdgeId, std::vector<ProviderId>> requesters_;
  IdTable<StateId, std::vector<Setter>> setters_;
};

/// The parts of a plan.
class Plan {
public:
  explicit Plan(const Model& model)
      : edges(model.edges.size()),
        states(model.states.size()),
        pack(model.providers.size()),
        puts(model.providers.size()),
        model_(model),
        planner_(model),
        seen_(model.providers.size()) {}

  void add(GroupId group) {
    if (const auto id = planner_.cheapest(group)) add(*id);
  }

  void add(ProviderId id) {
    if (seen_[id.value] || planner_.cost(id) >= never) return;
    seen_[id.value] = true;
    const Provider& provider = model_.providers[id];
    if (const auto edge = planner_.request(provider.group)) add(*edge);
    for (const ConditionUse& use : provider.when) add(use.id);
    for (const ProviderId earlier : model_.groups[provider.group].providers) { // which would run in its place
      for (const ConditionUse& use : model_.providers[earlier].when)
        states[model_.conditions[use.id].state.value] = true;
    }
  }

  /// Adds a task that waits for its promise: a provider that is not the first choice is pushed for that.
  void add_pusher(ProviderId pushed) {
    std::optional<ProviderId> best;
    for (const ProviderId id : model_.providers.ids()) {
      const Provider& provider = model_.providers[id];
      const bool waits = std::any_of(provider.when.begin(), provider.when.end(),
                                     [&](const ConditionUse& use) { return model_.causes(pushed, use.id); });
      if (waits && planner_.cost(id) < never && (!best || planner_.cost(id) < planner_.cost(*best))) best = id;
    }
    if (best) add(*best);
  }

  std::vector<bool> edges;                            ///< that are requested
  std::vector<bool> states;                           ///< that inputs set
  IdTable<ProviderId, std::vector<EdgeId>> pack;      ///< what its body requests
  IdTable<ProviderId, std::vector<ConditionId>> puts; ///< what its body makes true

private:
  void add(EdgeId id) {
    if (edges[id.value]) return;
    edges[id.value] = true;
    if (const auto by = planner_.way(id).by) {
      pack[*by].push_back(id);
      add(*by);
    }
  }

  void add(ConditionId id) {
    states[model_.conditions[id].state.value] = true;
    if (const auto by = planner_.way(id).by) {
      puts[*by].push_back(id);
      add(*by);
    }
  }

  const Model& model_;
  Planner planner_;
  std::vector<bool> seen_;
};

/// Adds the places, within a range, of the largest and the smallest pack that requests the edge.
void add_extremes(const std::vector<RequestedPack>& packs, std::size_t begin, std::size_t end, EdgeId edge,
                  std::vector<std::size_t>& places) {
  std::optional<std::size_t> most, least;
  for (std::size_t i = begin; i < end; ++i) {
    const auto requested = [&](const RequestedLevel& request) { return request.edge == edge.value; };
    if (std::none_of(packs[i].begin(), packs[i].end(), requested)) continue;
    if (!most || packs[i].size() > packs[*most].size()) most = i;
    if (!least || packs[i].size() < packs[*least].size()) least = i;
  }
  for (const auto& place : {most, least}) {
    if (place && std::find(places.begin(), places.end(), *place) == places.end()) places.push_back(*place);
  }
}

/// Keeps the usual answer, and for each requested edge the largest and the smallest pack, with and without those that
/// leave out optional entries.
void keep_packs(FreeBody& body, const std::vector<EdgeId>& edges) {
  std::vector<std::size_t> kept{0};
  for (const EdgeId edge : edges) add_extremes(body.packs, 0, body.usual, edge, kept);
  const std::size_t usual = kept.size();
  for (const EdgeId edge : edges) add_extremes(body.packs, body.usual, body.packs.size(), edge, kept);
  std::vector<RequestedPack> out;
  for (const std::size_t place : kept) out.push_back(body.packs[place]);
  body.packs = std::move(out);
  body.usual = usual;
}

void keep_puts(std::vector<Puts>& puts, const std::vector<ConditionId>& conditions, const Model& model) {
  std::vector<Puts> out{puts.front()};
  for (const ConditionId id : conditions) {
    const Condition& condition = model.conditions[id];
    const auto made = std::find_if(puts.begin(), puts.end(), [&](const Puts& each) {
      return std::any_of(each.begin(), each.end(), [&](const Put& put) {
        return put.state == condition.state.value && condition.accepts.contains(put.value);
      });
    });
    if (made != puts.begin() && made != puts.end()) out.push_back(*made);
  }
  puts = std::move(out);
}

} // namespace

void focus_on(Ground& ground, const Goal& goal) {
  const Model& model = ground.model;
  Plan plan(model);
  for (const GroupId id : goal.groups) plan.add(id);
  for (const ProviderId id : goal.providers) {
    plan.add(id);
    plan.add_pusher(id);
  }
  for (const ProviderId id : model.providers.ids()) {
    FreeBody& body = ground.bodies[id.value];
    keep_packs(body, plan.pack[id]);
    keep_puts(body.puts, plan.puts[id], model);
  }
  const auto not_planned = [&](const RequestedPack& pack) {
    return pack.size() != 1 || !plan.edges[pack.front().edge];
  };
  ground.requests.erase(std::remove_if(ground.requests.begin(), ground.requests.end(), not_planned),
                        ground.requests.end());
  const auto not_set = [&](const Puts& puts) { return puts.size() != 1 || !plan.states[puts.front().state]; };
  ground.sets.erase(std::remove_if(ground.sets.begin(), ground.sets.end(), not_set), ground.sets.end());
  ground.triggers.clear();
  ground.expiries.clear();
  ground.broken.clear();
  std::fill(ground.wake.begin(), ground.wake.end(), nil);
}

} // namespace director::compiler
