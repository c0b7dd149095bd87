// Header: compiler/analysis/states/choice.hpp. Test: tests/compiler/analysis/states/choice_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/states/choice.hpp"

#include "compiler/graph/graph.hpp"

#include <algorithm>
#include <limits>

namespace director::analysis {

namespace {

/// Limit for the ways of one rival; further ones are left out.
constexpr std::size_t most_ways = 16;

constexpr std::size_t most_providers = std::numeric_limits<std::size_t>::max();

void find_parties(const Model& model, ProviderId rival, std::set<GroupId>& out) {
  if (model.providers[rival].needs.empty()) return;
  out.insert(model.providers[rival].group);
  std::vector<ProviderId> open{rival};
  while (!open.empty()) {
    const ProviderId id = open.back();
    open.pop_back();
    for (const Use<GroupId>& need : model.providers[id].needs) {
      if (!out.insert(need.id).second) continue;
      const std::vector<ProviderId>& below = model.groups[need.id].providers;
      open.insert(open.end(), below.begin(), below.end());
    }
  }
}

} // namespace

Rivals::Rivals(const Model& model, const IdSet<EdgeId>& holding, const IdSet<ProviderId>& active)
    : model_(model),
      holding_(holding),
      active_(active),
      place_(model.providers.size()),
      deciding_(model.groups.size(), most_providers),
      below_(edge_arrows(model), root_node(model)) {
  for (const GroupId id : model.groups.ids()) {
    const Group& group = model.groups[id];
    std::vector<Region> regions;
    for (std::size_t place = 0; place < group.providers.size(); ++place) {
      const Provider& row = model.providers[group.providers[place]];
      place_[group.providers[place]] = place;
      if (row.when.empty() && row.needs.empty()) deciding_[id] = std::min(deciding_[id], place + 1);
      regions.push_back(region_of(model, model.providers[group.providers[place]].when));
    }
    regions_.add(RegionIndex(std::move(regions)));
  }
}

std::vector<Rival> Rivals::that_meet(ProviderId provider, const Region& region,
                                     const std::function<bool(const Rival&)>& counts) const {
  const GroupId group = model_.providers[provider].group;
  std::vector<Rival> out;
  regions_[group].visit_meeting(region, std::min(place_[provider], deciding_[group]), [&](std::size_t place) {
    const ProviderId rival = model_.groups[group].providers[place];
    Comparison comparison{provider, {group}, {}};
    find_parties(model_, rival, comparison.parties);
    std::vector<Region> ways = this->ways(rival, comparison);
    if (ways.empty()) return true;
    const bool is_free = std::any_of(ways.begin(), ways.end(), [](const Region& way) { return way.states.empty(); });
    out.push_back({rival, std::move(ways)});
    return !is_free || !counts(out.back());
  });
  return out;
}

std::vector<Region> Rivals::ways(ProviderId rival, Comparison& comparison) const {
  const Provider& row = model_.providers[rival];
  std::vector<Region> out{region_of(model_, row.when)};
  for (const Use<GroupId>& need : row.needs) {
    std::vector<Region> both;
    for (const Region& below : ways(need.id, row.group, comparison)) {
      for (const Region& own : out) {
        if (both.size() == most_ways) break;
        Region way = own;
        way.meet(below);
        both.push_back(std::move(way));
      }
    }
    out = std::move(both);
    if (out.empty()) break;
  }
  return out;
}

std::vector<Region> Rivals::ways(GroupId group, GroupId needer, Comparison& comparison) const {
  // The later provider holds its own needs by the same edge. Needs of only a part of its plan do not count: an equal
  // from which that part may get the group may deny it to this one.
  const Provider& provider = model_.providers[comparison.provider];
  if (needer == provider.group && provider.needs_group(group)) return {Region{}};
  std::vector<GroupId>& path = comparison.path;
  if (std::find(path.begin(), path.end(), group) != path.end() || is_contended(group, needer, comparison)) return {};
  path.push_back(group);
  std::vector<Region> out;
  for (const ProviderId id : model_.groups[group].providers) {
    for (Region& way : ways(id, comparison)) {
      if (out.size() < most_ways) out.push_back(std::move(way));
    }
  }
  path.pop_back();
  return out;
}

/// Whether a group other than `needer` may hold it when the provider's group is tried, or take it in the same plan.
bool Rivals::is_contended(GroupId group, GroupId needer, const Comparison& comparison) const {
  const GroupId above = model_.providers[comparison.provider].group;
  const std::vector<EdgeId>& all = model_.groups[group].requesters;
  return std::any_of(all.begin(), all.end(), [&](EdgeId id) {
    const Edge& edge = model_.edges[id];
    if (edge.requester == needer) return false;
    if (edge.needed && comparison.parties.count(*edge.requester) != 0) return true;
    return holding_.contains(id) &&
           (!edge.requester || needer != above || goes_without(*edge.requester, group, comparison.provider));
  });
}

/// Whether the groups below the provider's group hold nothing except what all providers there need themselves.
bool Rivals::goes_without(GroupId holder, GroupId group, ProviderId provider) const {
  const GroupId above = model_.providers[provider].group;
  if (holder == above || !below_.is_below(holder.value, above.value)) return true;
  const std::vector<EdgeId>& requesters = model_.groups[above].requesters;
  if (std::any_of(requesters.begin(), requesters.end(),
                  [&](EdgeId id) { return model_.edges[id].needed && holding_.contains(id); }))
    return true;
  const std::vector<ProviderId>& all = model_.groups[above].providers;
  return std::any_of(all.begin(), all.end(),
                     [&](ProviderId id) { return active_.contains(id) && !model_.providers[id].needs_group(group); });
}

Covering find_covering(const Model& model, const Region& own, const std::vector<Region>& others,
                       const IdTable<StateId, ValueSet>& values, Budget& budget) {
  Box start;
  for (const auto& [state, accepted] : own.states)
    start.emplace(state, Possible{values[state].intersected(accepted), false});
  return find_covering(model, values, start, others, budget);
}

Covering find_choice(const Model& model, const Region& own, const std::vector<Rival>& rivals,
                     const IdTable<StateId, ValueSet>& values, Budget& budget) {
  std::vector<Region> others;
  for (const Rival& rival : rivals) others.insert(others.end(), rival.ways.begin(), rival.ways.end());
  return find_covering(model, own, others, values, budget);
}

} // namespace director::analysis
