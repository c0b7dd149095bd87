// Header: compiler/analysis/conflicts/takers.hpp. Test: compiler/checks/starved_task.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/takers.hpp"

#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/needs/units.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/choice.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

namespace director::analysis {

namespace {

/// Limit for the ways to grant a unit; with more, only what its members must have is known.
constexpr std::size_t most_ways_known = 64;

void sort_out(Groups& groups) {
  std::sort(groups.begin(), groups.end());
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
}

/// Whether the test holds for every level of the one entry with every level of the other.
template <class Test>
bool at_all_levels(const Model& model, const Task& first, const Task& second, const Test& test) {
  const std::vector<Level>& a = model.edges[first.edge].levels;
  const std::vector<Level>& b = model.edges[second.edge].levels;
  return std::all_of(first.levels.begin(), first.levels.end(), [&](const Task::NamedLevel& x) {
    return std::all_of(second.levels.begin(), second.levels.end(),
                       [&](const Task::NamedLevel& y) { return test(a[x.level], b[y.level]); });
  });
}

} // namespace

bool has(const Groups& groups, GroupId group) { return std::binary_search(groups.begin(), groups.end(), group); }

Groups joined(const Groups& a, const Groups& b) {
  Groups out;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
  return out;
}

Groups in_common(const Groups& a, const Groups& b) {
  Groups out;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
  return out;
}

Takers::Takers(const Input& input)
    : input_(input),
      place_(input.model.groups.size()),
      unconditional_(input.model.groups.size()),
      parts_(input.model, &input.facts.capable) {
  for (std::size_t place = 0; place < input.graph.order.size(); ++place)
    place_[GroupId{input.graph.order[place]}] = place;
  for (const PackConflict& conflict : input.conflicts.pack_conflicts()) {
    if (conflict.verdict == UnitVerdict::impossible && input.model.providers[conflict.provider].has_packs)
      never_whole_.insert(conflict.pack);
  }
}

const Groups& Takers::must(ProviderId id) {
  const auto [at, is_new] = must_of_provider_.try_emplace(id);
  if (!is_new) return at->second;
  const Provider& provider = input_.model.providers[id];
  Groups& out = at->second;
  out.push_back(provider.group);
  for (const Use<GroupId>& need : provider.needs) {
    const auto& parts = parts_.of(need.id);
    if (parts) out = joined(out, *parts);
  }
  return out;
}

const Groups& Takers::must(GroupId group) {
  const auto [at, is_new] = must_of_group_.try_emplace(group);
  if (!is_new) return at->second;
  std::optional<Groups> out;
  for (const ProviderId id : input_.model.groups[group].providers) {
    if (input_.facts.active.contains(id)) out = out ? in_common(*out, must(id)) : must(id);
  }
  return at->second = out.value_or(Groups{group});
}

Groups Takers::held_by(GroupId group, const std::vector<ProviderId>& running) {
  std::optional<Groups> out;
  const auto add = [&](ProviderId id) { out = out ? in_common(*out, must(id)) : must(id); };
  for (const ProviderId id : running) add(id);
  if (is_needed(group)) {
    for (const ProviderId id : input_.model.groups[group].providers) {
      if (input_.facts.capable.contains(id)) add(id);
    }
  }
  return out.value_or(Groups{});
}

const Groups& Takers::held_by(GroupId group) {
  const auto [at, is_new] = held_by_group_.try_emplace(group);
  if (!is_new) return at->second;
  std::vector<ProviderId> running;
  for (const ProviderId id : input_.model.groups[group].providers) {
    if (input_.facts.active.contains(id)) running.push_back(id);
  }
  return at->second = held_by(group, running);
}

Groups Takers::needers(GroupId holder, GroupId group) {
  const Groups& all = input_.shared.units().needed(holder);
  Groups out;
  const std::vector<EdgeId>& requesters = input_.model.groups[group].requesters;
  const auto look = [&](EdgeId id) {
    const Edge& edge = input_.model.edges[id];
    if (edge.needed && edge.target == group && has(all, *edge.requester)) out.push_back(*edge.requester);
  };
  if (requesters.size() <= all.size()) {
    std::for_each(requesters.begin(), requesters.end(), look);
  } else {
    for (const GroupId each : all) {
      const std::vector<EdgeId>& edges = input_.model.groups[each].edges;
      std::for_each(edges.begin(), edges.end(), look);
    }
  }
  sort_out(out);
  return out;
}

Region Takers::region_of_requests(GroupId requester) const {
  // Requests remain while any provider of the group runs, also a pushed one, whose own promise is then waived.
  std::optional<Region> out;
  for (const ProviderId id : input_.model.groups[requester].providers) {
    if (!input_.facts.active.contains(id)) continue;
    const Region own = input_.facts.region_to_run(input_.model, id, true);
    out = out ? hull(*out, own) : own;
  }
  return out.value_or(Region{});
}

bool Takers::covers(const Region& region, const std::vector<Region>& ways) const {
  return find_covering(input_.model, region, ways, input_.facts.values, input_.shared.budget()) == Covering::covered;
}

const UnitTakes& Takers::takes(GroupId requester, const Unit& unit) {
  const auto [at, is_new] = takes_.try_emplace({requester, unit.front()});
  if (!is_new) return at->second;
  const Model& model = input_.model;
  const Region here = region_of_requests(requester);
  std::vector<GroupId> members;
  for (const Task* member : unit) members.push_back(member->target);
  std::vector<std::vector<Groups>> ways; ///< in the order in which they are tried: what each member takes
  std::vector<Region> regions;           ///< in which they can be used
  std::optional<std::size_t> first_ones; ///< so many of them, of which one can always be used
  bool is_pushed = false;
  const bool complete = input_.shared.units().visit(members, false, [&](const Combination& combination) {
    Region region;
    std::vector<Groups> way;
    for (const Combination::Pick& pick : combination.picks) {
      if (!input_.facts.capable.contains(pick.provider)) return true;
      is_pushed = is_pushed || input_.facts.pushed.contains(pick.provider);
      region.meet(region_of(model, model.providers[pick.provider].when));
      // A member's needs come after it, before the next member.
      if (way.size() < members.size() && pick.group == members[way.size()]) way.emplace_back();
      way.back().push_back(pick.group);
    }
    for (Groups& groups : way) sort_out(groups);
    ways.push_back(std::move(way));
    regions.push_back(std::move(region));
    if (!first_ones && covers(here, regions)) first_ones = ways.size();
    return ways.size() <= most_ways_known;
  });
  UnitTakes out;
  const auto common = [&](std::size_t count) {
    std::vector<Groups> all = ways.front();
    for (std::size_t way = 1; way < count; ++way) {
      for (std::size_t i = 0; i < all.size(); ++i) all[i] = in_common(all[i], ways[way][i]);
    }
    return all;
  };
  const bool has_all = complete && !ways.empty() && ways.size() <= most_ways_known;
  if (has_all) {
    out.always = common(ways.size());
  } else {
    for (const GroupId member : members) out.always.push_back(must(member));
  }
  // A push changes the order.
  if (is_pushed && first_ones) first_ones = has_all ? std::optional(ways.size()) : std::nullopt;
  if (first_ones) {
    out.at_first = common(*first_ones);
    out.maybe.resize(members.size());
    for (std::size_t way = 0; way < *first_ones; ++way) {
      for (std::size_t i = 0; i < members.size(); ++i) out.maybe[i] = joined(out.maybe[i], ways[way][i]);
    }
  }
  out.disputed = find_disputed(requester, unit);
  return takes_[{requester, unit.front()}] = std::move(out);
}

Groups Takers::find_disputed(GroupId requester, const Unit& unit) const {
  Groups out;
  for (const Task* taking : unit) {
    const Groups& taken = input_.shared.units().needed(taking->target);
    for (const Task* other : unit) {
      const bool never_equal = at_all_levels(input_.model, *taking, *other, [](const Level& a, const Level& b) {
        return a.optional != b.optional || a.priority != b.priority;
      });
      if (other == taking || never_equal || always_beside(requester, *taking, *other)) continue;
      const Claims& claims = input_.shared.claims(other->target);
      std::copy_if(taken.begin(), taken.end(), std::back_inserter(out), [&](GroupId group) {
        return group != other->target &&
               (claims.find(group, Reach::own) != nullptr || claims.find(group, Reach::mandatory) != nullptr);
      });
    }
  }
  sort_out(out);
  return out;
}

bool Takers::is_unconditional(GroupId group) {
  if (!input_.facts.may_wait.contains(group)) return true;
  if (unconditional_[group]) return *unconditional_[group];
  const Groups& needed = input_.shared.units().needed(group);
  return *(unconditional_[group] = std::all_of(needed.begin(), needed.end(), [&](GroupId each) {
             const std::vector<ProviderId>& all = input_.model.groups[each].providers;
             return std::all_of(all.begin(), all.end(), [&](ProviderId id) {
               return !input_.facts.capable.contains(id) ||
                      covers(Region{}, {region_of(input_.model, input_.model.providers[id].when)});
             });
           }));
}

bool Takers::is_alive(EdgeId id) const {
  const Edge& edge = input_.model.edges[id];
  if (!edge.requester || input_.facts.requested.contains(*edge.requester)) return true;
  const std::vector<EdgeId>& above = input_.model.groups[*edge.requester].requesters;
  return edge.needed &&
         std::any_of(above.begin(), above.end(), [&](EdgeId each) { return input_.model.edges[each].needed; });
}

bool Takers::always_before(const Task& first, const Task& second) const {
  return at_all_levels(input_.model, first, second, [](const Level& a, const Level& b) {
    return a.optional == b.optional ? a.priority > b.priority : b.optional;
  });
}

bool Takers::always_first_of_equals(GroupId requester, const Task& first, const Task& second) const {
  return first.edge < second.edge && input_.model.edges[first.edge].levels.size() == 1 &&
         always_beside(requester, first, second);
}

bool Takers::always_beside(GroupId requester, const Task& first, const Task& second) const {
  const Model& model = input_.model;
  const bool equal = at_all_levels(model, first, second, [](const Level& a, const Level& b) {
    return a.optional == b.optional && a.priority == b.priority;
  });
  if (!equal) return false;
  for (const ProviderId id : model.groups[requester].providers) {
    const Provider& provider = model.providers[id];
    for (const Pack& pack : provider.packs) {
      if (pack.requests(second.edge) && !(provider.has_packs && pack.requests(first.edge))) return false;
    }
  }
  return true;
}

bool Takers::may_change_holder(GroupId id) const {
  const std::vector<EdgeId>& all = input_.model.groups[id].requesters;
  return all.size() > 1 || std::any_of(all.begin(), all.end(),
                                       [&](EdgeId edge) { return input_.model.edges[edge].requester.has_value(); });
}

bool Takers::may_become_stale(GroupId id) const {
  return input_.model.groups[id].providers.size() > 1 || may_change_holder(id);
}

bool Takers::may_be_equals(GroupId a, GroupId b) {
  const auto [at, is_new] = may_be_equals_.try_emplace({a, b}, true);
  if (!is_new || input_.shared.claims(a).contains(b) || input_.shared.claims(b).contains(a)) return at->second;
  at->second = false;
  input_.shared.chains().visit(a, {b}, [&, &out = at->second](const Meeting& meeting, GroupId) {
    out = out || meeting.first_level.priority == meeting.second_level.priority;
  });
  return at->second;
}

bool Takers::is_needed(GroupId group) const {
  const std::vector<EdgeId>& all = input_.model.groups[group].requesters;
  return std::any_of(all.begin(), all.end(), [&](EdgeId id) { return input_.model.edges[id].needed && is_alive(id); });
}

bool Takers::is_mandatory(const Task& task) const {
  return input_.model.each_level(task, [](const Level& level) { return !level.optional; });
}

bool Takers::is_optional(const Task& task) const {
  return input_.model.each_level(task, [](const Level& level) { return level.optional; });
}

bool Takers::is_member(const Task& task) const { return input_.model.is_always_member(task); }

bool Takers::is_apart(const Task& task) const {
  return input_.model.each_level(task, [](const Level& level) { return level.apart; });
}

} // namespace director::analysis
