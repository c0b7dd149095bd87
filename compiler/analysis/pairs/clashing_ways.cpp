// Header: compiler/analysis/pairs/clashing_ways.hpp. Test: compiler/checks/possible_pack_conflict.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/pairs/clashing_ways.hpp"

#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/choice.hpp"

#include <algorithm>
#include <set>

namespace director::analysis {

namespace {

/// Whether the tasks and all that they may need are requested and needed by nothing else: then both begin at once.
bool begin_together(const Input& input, const Task& first, const Task& second) {
  Units& units = input.shared.units();
  std::set<GroupId> all;
  for (const Task* task : {&first, &second}) {
    const std::vector<GroupId>& needed = units.needed(task->target);
    all.insert(needed.begin(), needed.end());
  }
  return std::all_of(all.begin(), all.end(), [&](GroupId group) {
    std::size_t entries = 0;
    for (const Request& request : input.shared.requests().of(group)) {
      if (!request.requester || all.count(input.model.providers[*request.requester].group) == 0) ++entries;
    }
    const std::vector<EdgeId>& edges = input.model.groups[group].requesters;
    return entries <= 1 && std::all_of(edges.begin(), edges.end(), [&](EdgeId id) {
             const Edge& edge = input.model.edges[id];
             const bool is_its = (id == first.edge || id == second.edge) && !edge.needed;
             return is_its || (edge.requester && all.count(*edge.requester) != 0);
           });
  });
}

} // namespace

Region beginning(const Input& input, const Way& way) {
  Region out = way.combination.region;
  for (const Combination::Pick& pick : way.combination.picks) {
    const Provider& provider = input.model.providers[pick.provider];
    Region own = input.facts.region_to_begin(input.model, pick.provider);
    for (const ConditionUse& promise : provider.causing) own.states.erase(input.model.conditions[promise.id].state);
    out.meet(own);
  }
  return out;
}

PairSearch::PairSearch(const Input& input, const Sides& sides) : input_(input) {
  for (const Way& a : sides.first.ways) {
    for (const Way& b : sides.second.ways) {
      Region region = a.combination.region;
      region.meet(b.combination.region);
      if (region.empty()) continue;
      (groups_in_common(a, b).empty() ? working_ : clashing_).push_back({&a, &b, std::move(region)});
    }
  }
  const auto can_begin = [&](const Pair& pair) {
    return compatible(beginning(input, *pair.first), beginning(input, *pair.second));
  };
  const auto others = std::stable_partition(working_.begin(), working_.end(), can_begin);
  if (others == working_.begin() && !working_.empty() && begin_together(input, sides.first.task, sides.second.task))
    working_.clear();
}

bool PairSearch::has(ProviderId id) const {
  const auto is_its = [&](const Pair& pair) { return pair.first->provider() == id || pair.second->provider() == id; };
  return std::any_of(working_.begin(), working_.end(), is_its) ||
         std::any_of(clashing_.begin(), clashing_.end(), is_its);
}

std::optional<ClashingWays> PairSearch::all_clash() const {
  if (clashing_.empty() || !working_.empty()) return std::nullopt;
  return ClashingWays{clashing_.front().first, clashing_.front().second, nullptr, nullptr, {}, true};
}

std::optional<ClashingWays> PairSearch::run() const {
  if (clashing_.empty() || working_.empty()) return std::nullopt;
  if (const Pair* useless = find_useless()) return make(*useless, true);
  std::vector<Region> regions;
  for (const Pair& pair : working_) regions.push_back(pair.region);
  for (const Pair& pair : clashing_) {
    if (find_covering(input_.model, pair.region, regions, input_.facts.values, input_.shared.budget()) ==
        Covering::open)
      return make(pair, false);
  }
  return std::nullopt;
}

ClashingWays PairSearch::make(const Pair& pair, bool always) const {
  ClashingWays out{pair.first, pair.second, working_.front().first, working_.front().second, {}, always};
  for (const auto side : {&Pair::first, &Pair::second}) {
    const ProviderId id = (pair.*side)->provider();
    if (std::none_of(working_.begin(), working_.end(),
                     [&](const Pair& works) { return (works.*side)->provider() == id; }))
      out.losers.push_back(id);
  }
  return out;
}

/// A conflict of a provider that is preferred to all that ever run here.
const PairSearch::Pair* PairSearch::find_useless() const {
  const auto before_all = [&](const Way* way, const Way* Pair::*side) {
    return std::all_of(working_.begin(), working_.end(),
                       [&](const Pair& pair) { return way->provider() < (pair.*side)->provider(); });
  };
  for (const Pair& pair : clashing_) {
    if (before_all(pair.first, &Pair::first) || before_all(pair.second, &Pair::second)) return &pair;
  }
  return nullptr;
}

} // namespace director::analysis
