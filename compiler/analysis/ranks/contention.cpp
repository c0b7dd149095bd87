// Header: compiler/analysis/ranks/contention.hpp. Test: tests/compiler/analysis/ranks/contention_test.cpp.
// SPDX-License-Identifier: MIT
//
// A chain never meets a group twice, because a group has one holder. For the same reason two chains that parted never
// meet again. So both are climbed at once, always the one whose requester is later in the order of requests: it cannot
// reach a group that the other one has visited, except its first one. If both reach one requester, they part there.
// What is above two edges does not depend on what was climbed below, so each pair is examined once. Cost: the square of
// the edges above, times the places where they part.
//
// A group that its requester needs is held by that need. So the last edge of a chain is not optional there, even if it
// is requested as optional too; what is requested below that group is. Such an edge is in the table twice, if the
// requester needs the group with each of its providers.
//
// Requests can form a cycle that has an optional one. Neither of two groups of one cycle is later, so either side is
// climbed there, and a pair may lead to itself: then all is examined again until nothing is added. Chains around a
// cycle are included; they add no other places, and at most that something is optional.

#include "compiler/analysis/ranks/contention.hpp"

#include "compiler/graph/algorithms.hpp"
#include "compiler/graph/graph.hpp"

#include <algorithm>
#include <set>

namespace director::analysis {

namespace {

/// Every way in which an edge can hold. As a need it counts as mandatory, with the priority of its first level.
std::set<SideRank> ways(const Edge& edge) {
  std::set<SideRank> out;
  for (const Level& level : edge.levels) out.insert({level.priority, level.optional});
  if (edge.needed) out.insert({edge.levels.empty() ? 0 : edge.levels.front().priority, false});
  return out;
}

std::set<SideRank> ranks_of(const Edge& edge, bool optional_below) {
  std::set<SideRank> out;
  for (const SideRank& way : ways(edge)) out.insert({way.priority, way.optional || optional_below});
  return out;
}

/// Whether each provider of the requester needs what some request as optional too. A request remains while the
/// requester changes to another provider: where that one does not need the group, it holds by the request alone.
bool is_always_needed(const Model& model, EdgeId id) {
  const Edge& edge = model.edges[id];
  const auto is_optional = [](const Level& level) { return level.optional; };
  if (!edge.needed || std::none_of(edge.levels.begin(), edge.levels.end(), is_optional)) return false;
  const std::vector<ProviderId>& providers = model.groups[*edge.requester].providers;
  return std::all_of(providers.begin(), providers.end(),
                     [&](ProviderId provider) { return model.providers[provider].needs_group(edge.target); });
}

template <class Value>
void keep_different(std::vector<Value>& all) {
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
}

} // namespace

int order_of(const Decision& decision) {
  const SideRank &first = decision.first, &second = decision.second;
  if (first.optional != second.optional) return first.optional ? 1 : -1;
  if (first.priority != second.priority) return first.priority > second.priority ? -1 : 1;
  return 0;
}

Contentions::Contentions(const Model& model, std::size_t pairs, std::size_t partings)
    : model_(model),
      edges_(model.edges),
      pairs_left_(pairs),
      partings_left_(partings),
      place_(model.groups.size(), 0),
      is_requested_(model.groups.size(), false),
      cycle_(model.groups.size(), 0) {
  const Node root = root_node(model);
  const Arrows arrows = edge_arrows(model);
  std::size_t place = 0;
  for (const Node node : topological_order(arrows)) {
    if (node != root) place_[GroupId{node}] = ++place;
  }
  std::size_t number = 0;
  for (const std::vector<Node>& cycle : cycles(arrows)) {
    ++number;
    for (const Node node : cycle) cycle_[GroupId{node}] = number;
  }
  for (const EdgeId id : model.edges.ids()) last_.add(id);
  for (const EdgeId id : model.edges.ids()) {
    if (!is_always_needed(model, id)) continue;
    Edge held = model.edges[id];
    for (Level& level : held.levels) level.optional = false;
    last_[id] = edges_.add(std::move(held));
    last_.add(id);
  }
  const std::vector<bool> reached = reachable(arrows, root);
  for (const GroupId id : model.groups.ids()) is_requested_[id] = reached[id.value];
}

const Contentions::Partings& Contentions::partings(EdgeId first, EdgeId second) {
  again_ = false;
  do {
    ++round_;
    met_open_ = changed_ = false;
    look_at(first, second);
    again_ = true;
  } while (met_open_ && changed_ && cycle_steps_left_ > 0);
  for (Known* each : unsettled_) each->settled = true;
  unsettled_.clear();
  return known_.at({first, second}).all;
}

/// The partings that are known so far.
const Contentions::Partings& Contentions::look_at(EdgeId first, EdgeId second) {
  const auto [at, fresh] = known_.try_emplace({first, second});
  Known& it = at->second;
  if (fresh) {
    it.settled = pairs_left_ == 0 || partings_left_ == 0;
    if (it.settled) return it.all;
    --pairs_left_;
    unsettled_.push_back(&it);
  }
  met_open_ = met_open_ || it.open;
  if (it.settled || it.round == round_) return it.all;
  it.round = round_;
  it.open = true;
  Partings found = find(first, second);
  it.open = false;
  if (found.size() > it.all.size()) { // the set only grows, unless the search was cut off
    changed_ = true;
    partings_left_ -= std::min(partings_left_, found.size() - it.all.size());
    it.all = std::move(found);
  }
  return it.all;
}

Contentions::Partings Contentions::find(EdgeId first, EdgeId second) {
  const std::optional<GroupId> a = edges_[first].requester, b = edges_[second].requester;
  if (a == b) return !a || is_requested_[*a] ? Partings{{first, second, false, false}} : Partings{};
  const bool either = a && b && cycle_[*a] != 0 && cycle_[*a] == cycle_[*b];
  const bool climbs_first = a && (!b || place_[*a] > place_[*b]);
  Partings out;
  if (climbs_first || either) climb(first, second, true, out);
  if (!climbs_first || either) climb(first, second, false, out);
  keep_different(out);
  return out;
}

void Contentions::climb(EdgeId first, EdgeId second, bool climbs_first, Partings& out) {
  const Edge& below = edges_[climbs_first ? first : second];
  const Edge& beside = edges_[climbs_first ? second : first];
  if (*below.requester == beside.target) return; // the one leads to the other
  for (const EdgeId above : model_.groups[*below.requester].requesters) {
    for (const Parting& each : climbs_first ? look_at(above, second) : look_at(first, above)) {
      for (const SideRank& way : ways(below)) {
        if (again_ && cycle_steps_left_ == 0) return;
        if (again_) --cycle_steps_left_;
        Parting with = each;
        bool& optional = climbs_first ? with.first_optional : with.second_optional;
        optional = optional || way.optional;
        out.push_back(with);
      }
    }
  }
}

std::vector<Decision> Contentions::decisions(const Partings& partings) const {
  std::vector<Decision> out;
  for (const Parting& each : partings) {
    for (const SideRank& first : ranks_of(edges_[each.first], each.first_optional)) {
      for (const SideRank& second : ranks_of(edges_[each.second], each.second_optional))
        out.push_back({edges_[each.first].requester, original(each.first), original(each.second), first, second});
    }
  }
  keep_different(out);
  return out;
}

std::vector<Contention> Contentions::at(GroupId group) {
  const std::vector<EdgeId>& edges = model_.groups[group].requesters;
  std::vector<Contention> out;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      std::vector<Decision> found = decisions(partings(last_[edges[i]], last_[edges[j]]));
      out.push_back({edges[i], edges[j], std::move(found), complete()});
    }
  }
  return out;
}

std::vector<Decision> Contentions::between(GroupId first, GroupId second) {
  Partings all;
  for (const EdgeId a : model_.groups[first].requesters) {
    for (const EdgeId b : model_.groups[second].requesters) {
      if (first == second && !(a < b)) continue;
      const Partings& some = partings(last_[a], last_[b]);
      all.insert(all.end(), some.begin(), some.end());
    }
  }
  keep_different(all);
  return decisions(all);
}

} // namespace director::analysis
