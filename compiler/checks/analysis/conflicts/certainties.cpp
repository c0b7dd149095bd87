// Door: compiler/checks/analysis/conflicts/certainties.hpp. Test: compiler/checks/starved_task.md.
#include "compiler/checks/analysis/conflicts/certainties.hpp"

#include "compiler/checks/analysis/shared.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

namespace director::checks {

namespace {

void sort_out(Groups& groups) {
  std::sort(groups.begin(), groups.end());
  groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
}

} // namespace

bool has(const Groups& groups, GroupId group) { return std::binary_search(groups.begin(), groups.end(), group); }

Groups in_common(const Groups& a, const Groups& b) {
  Groups out;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
  return out;
}

const Certain& Certainties::of(GroupId group) {
  const auto [at, is_new] = certain_.try_emplace(group);
  if (!is_new) return at->second; // on the way round a circle: nothing
  Certain out;
  if (const auto& parts = input_.shared.indispensable().of(group)) out.own = *parts;
  out.depends = input_.shared.units().needed(group);
  std::optional<Groups> requested;
  for (const ProviderId id : input_.model.groups[group].providers) {
    if (!input_.facts.active.contains(id)) continue;
    Groups here = requested_by(input_.model.providers[id], out.depends);
    requested = requested ? in_common(*requested, here) : std::move(here);
  }
  out.all = out.own;
  if (requested) out.all.insert(out.all.end(), requested->begin(), requested->end());
  sort_out(out.all);
  sort_out(out.depends);
  return certain_[group] = std::move(out);
}

bool Certainties::never_waits(GroupId group, const Region& region) {
  std::vector<Region> providers;
  for (const ProviderId id : input_.model.groups[group].providers) {
    const Provider& provider = input_.model.providers[id];
    if (input_.facts.active.contains(id) || input_.facts.capable.contains(id)) {
      if (std::all_of(provider.needs.begin(), provider.needs.end(),
                      [&](const Use<GroupId>& need) { return never_waits(need.id); }))
        providers.push_back(region_of(input_.model, provider.when));
    }
  }
  return !may_escape(input_.model, region, providers, input_.facts.values);
}

bool Certainties::never_waits(GroupId group) {
  const auto [at, is_new] = never_waits_.try_emplace(group, false);
  if (!is_new) return at->second;
  const bool out = never_waits(group, Region{});
  return never_waits_[group] = out;
}

Groups Certainties::requested_by(const Provider& provider, Groups& depends) {
  std::optional<Groups> out;
  for (const Pack& pack : provider.packs) {
    Groups here;
    const std::vector<const Task*> members = unit_members(input_.model, pack);
    // A unit is granted whole: where one of them has to wait, all of them do.
    const bool never =
        std::all_of(members.begin(), members.end(), [&](const Task* member) { return never_waits(member->target); });
    for (const Task* member : members) {
      if (!never || !provider.has_packs) break;
      const Certain& below = of(member->target);
      here.insert(here.end(), below.all.begin(), below.all.end());
      depends.insert(depends.end(), below.depends.begin(), below.depends.end());
    }
    sort_out(here);
    out = out ? in_common(*out, here) : std::move(here);
  }
  return out.value_or(Groups{});
}

} // namespace director::checks
