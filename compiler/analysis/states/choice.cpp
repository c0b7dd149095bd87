// Door: compiler/analysis/states/choice.hpp. Test: tests/compiler/analysis/states/choice_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/states/choice.hpp"

#include <algorithm>

namespace director::analysis {

namespace {

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

} // namespace

Rivals::Rivals(const Model& model, const IdSet<GroupId>& claimable)
    : model_(model),
      claimable_(claimable),
      place_(model.providers.size()) {
  for (const GroupId id : model.groups.ids()) {
    const Group& group = model.groups[id];
    std::vector<Region> regions;
    for (std::size_t place = 0; place < group.providers.size(); ++place) {
      place_[group.providers[place]] = place;
      regions.push_back(region_of(model, model.providers[group.providers[place]].when));
    }
    regions_.add(RegionIndex(std::move(regions)));
  }
}

bool Rivals::is_needed(GroupId group) const {
  const std::vector<EdgeId>& all = model_.groups[group].requesters;
  return std::any_of(all.begin(), all.end(), [&](EdgeId id) {
    const Edge& edge = model_.edges[id];
    return edge.needed && claimable_.contains(*edge.requester);
  });
}

std::vector<ProviderId> Rivals::that_meet(ProviderId provider, const Region& region) const {
  const Availability availability{model_, claimable_};
  const GroupId group = model_.providers[provider].group;
  std::vector<ProviderId> out;
  for (const std::size_t place : regions_[group].meeting(region, place_[provider])) {
    const ProviderId rival = model_.groups[group].providers[place];
    // Two needs of one provider may come down to the same thing, and then a later choice has to serve.
    if (is_needed(group) && !model_.providers[rival].needs.empty()) continue;
    std::vector<GroupId> path{group};
    if (availability.is_free(rival, provider, path)) out.push_back(rival);
  }
  return out;
}

Covering find_covering(const Model& model, const Region& own, const std::vector<Region>& others,
                       const IdTable<StateId, ValueSet>& values, Budget& budget) {
  Box start;
  for (const auto& [state, accepted] : own.states)
    start.emplace(state, Possible{values[state].intersected(accepted), false});
  return find_covering(model, values, start, others, budget);
}

Covering find_choice(const Model& model, ProviderId provider, const std::vector<ProviderId>& rivals,
                     const IdTable<StateId, ValueSet>& values, Budget& budget) {
  std::vector<Region> others;
  for (const ProviderId rival : rivals) others.push_back(region_of(model, model.providers[rival].when));
  return find_covering(model, region_of(model, model.providers[provider].when), others, values, budget);
}

} // namespace director::analysis
