// Door: compiler/checks/analysis/states/choice.hpp. Test: tests/checks/analysis/states/choice_test.cpp.
#include "compiler/checks/analysis/states/choice.hpp"

#include <algorithm>

namespace director::checks {

namespace {

/// A group with this many providers before one that is undecided would be a riddle for people too.
constexpr int choice_steps = 100'000;

/// Groups that something alive may hold: the roots and all that they may request or need.
IdSet<GroupId> find_claimable(const Model& model, const Graph& graph) {
  IdSet<GroupId> out(model.groups.size());
  std::vector<GroupId> open;
  const auto reach = [&](GroupId group) {
    if (out.add(group)) open.push_back(group);
  };
  for (const Task& root : model.roots) reach(root.target);
  while (!open.empty()) {
    const GroupId group = open.back();
    open.pop_back();
    for (const Node next : graph.claims[group.value]) reach(GroupId{next});
  }
  return out;
}

struct Availability {
  const Model& model;
  const IdSet<GroupId>& claimable;

  /// Somebody but `needer` may hold it.
  bool is_contended(GroupId group, GroupId needer) const {
    return std::any_of(model.groups[group].requesters.begin(), model.groups[group].requesters.end(), [&](EdgeId id) {
      const Edge& edge = model.edges[id];
      return !edge.requester || (*edge.requester != needer && claimable.contains(*edge.requester));
    });
  }

  /// The needs of `rival` can be met whenever those of `provider` are. `path`: the groups above, against going in
  /// circles.
  bool is_free(ProviderId rival, ProviderId provider, std::vector<GroupId>& path) const {
    const Provider& row = model.providers[rival];
    return std::all_of(row.needs.begin(), row.needs.end(),
                       [&](const Use<GroupId>& need) { return can_be_had(need.id, row.group, provider, path); });
  }

  bool can_be_had(GroupId group, GroupId needer, ProviderId provider, std::vector<GroupId>& path) const {
    // What that one needs itself it has by the same edge. What only a part of its plan needs does not count: an equal
    // that lets that part have it may deny it to this one.
    const auto& needs = model.providers[provider].needs;
    if (needer == model.providers[provider].group &&
        std::any_of(needs.begin(), needs.end(), [&](const auto& need) { return need.id == group; }))
      return true;
    if (is_contended(group, needer) || std::find(path.begin(), path.end(), group) != path.end()) return false;
    path.push_back(group);
    const std::vector<ProviderId>& providers = model.groups[group].providers;
    const bool out = std::any_of(providers.begin(), providers.end(), [&](ProviderId id) {
      return model.providers[id].when.empty() && is_free(id, provider, path);
    });
    path.pop_back();
    return out;
  }
};

/// What a state may be.
struct Possible {
  ValueSet values;
  bool unset = false;
  bool empty() const { return values.empty() && !unset; }
};

class FirstSearch {
public:
  FirstSearch(const Model& model, const IdTable<StateId, ValueSet>& values) : model_(model), values_(values) {}

  bool run(const Region& own, const std::vector<Region>& rivals) {
    for (const auto& [state, accepted] : own.states) now_[state] = {values_[state].intersected(accepted), false};
    if (std::any_of(now_.begin(), now_.end(), [](const auto& entry) { return entry.second.empty(); })) return false;
    regions_ = rivals;
    return all_fail();
  }

private:
  const Possible& now(StateId state) {
    return now_.try_emplace(state, Possible{values_[state], model_.states[state].may_be_unset()}).first->second;
  }

  /// All rivals can lack something at once. Not by recursion: they may be many.
  bool all_fail() {
    std::vector<Choice> choices;
    std::size_t rival = 0;
    while (true) {
      while (rival < regions_.size() && lacks_already(regions_[rival])) ++rival;
      if (rival == regions_.size()) return true;
      choices.push_back({rival, regions_[rival].states.begin(), {}});
      while (!take_next(choices.back())) {
        choices.pop_back();
        if (choices.empty()) return false;
        take_back(choices.back());
      }
      if (steps_ > choice_steps) return true;
      rival = choices.back().rival + 1;
    }
  }

  /// What a rival is made to lack.
  struct Choice {
    std::size_t rival;
    std::map<StateId, ValueSet>::const_iterator state;
    Possible before; ///< of that state
  };

  /// From `state` on the first that can be otherwise than the rival wants it.
  bool take_next(Choice& choice) {
    for (; choice.state != regions_[choice.rival].states.end(); ++choice.state) {
      if (++steps_ > choice_steps) return true;
      choice.before = now(choice.state->first);
      const Possible without{choice.before.values.without(choice.state->second), choice.before.unset};
      if (without.empty()) continue;
      now_[choice.state->first] = without;
      return true;
    }
    return false;
  }

  void take_back(Choice& choice) {
    now_[choice.state->first] = choice.before;
    ++choice.state;
  }

  /// Whatever else is taken from it: no choice is needed, and none would help where this one does not lead to an end.
  bool lacks_already(const Region& rival) {
    return std::any_of(rival.states.begin(), rival.states.end(), [&](const auto& entry) {
      const Possible& here = now(entry.first);
      return !here.unset && here.values.intersected(entry.second).empty();
    });
  }

  const Model& model_;
  const IdTable<StateId, ValueSet>& values_;
  std::map<StateId, Possible> now_;
  std::vector<Region> regions_;
  int steps_ = 0;
};

} // namespace

Rivals::Rivals(const Model& model, const Graph& graph)
    : model_(model),
      claimable_(find_claimable(model, graph)),
      needed_(model.groups.size()),
      place_(model.providers.size()) {
  for (const GroupId id : model.groups.ids()) {
    const Group& group = model.groups[id];
    if (std::any_of(group.requesters.begin(), group.requesters.end(),
                    [&](EdgeId edge) { return model.edges[edge].needed; }))
      needed_.add(id);
    std::vector<Region> regions;
    for (std::size_t place = 0; place < group.providers.size(); ++place) {
      place_[group.providers[place]] = place;
      regions.push_back(region_of(model, model.providers[group.providers[place]].when));
    }
    regions_.add(RegionIndex(std::move(regions)));
  }
}

std::vector<ProviderId> Rivals::that_meet(ProviderId provider, const Region& region) const {
  const Availability availability{model_, claimable_};
  const GroupId group = model_.providers[provider].group;
  std::vector<ProviderId> out;
  for (const std::size_t place : regions_[group].meeting(region, place_[provider])) {
    const ProviderId rival = model_.groups[group].providers[place];
    // Two needs of one provider may come down to the same thing, and then a later choice has to serve.
    if (needed_.contains(group) && !model_.providers[rival].needs.empty()) continue;
    std::vector<GroupId> path{group};
    if (availability.is_free(rival, provider, path)) out.push_back(rival);
  }
  return out;
}

bool may_escape(const Model& model, const Region& own, const std::vector<Region>& others,
                const IdTable<StateId, ValueSet>& values) {
  return FirstSearch(model, values).run(own, others);
}

bool may_come_first(const Model& model, ProviderId provider, const std::vector<ProviderId>& rivals,
                    const IdTable<StateId, ValueSet>& values, const std::vector<StateId>& open) {
  Region own = region_of(model, model.providers[provider].when);
  for (const StateId state : open) own.states.erase(state);
  std::vector<Region> others;
  for (const ProviderId rival : rivals) others.push_back(region_of(model, model.providers[rival].when));
  return may_escape(model, own, others, values);
}

} // namespace director::checks
