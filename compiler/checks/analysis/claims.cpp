// Door: compiler/checks/analysis/claims.hpp. Test: compiler/checks/equal_priority.md.
#include "compiler/checks/analysis/claims.hpp"

#include <algorithm>
#include <deque>

namespace director::checks {

namespace {

/// One way down from a group, and the states under which it is open.
struct Branch {
  GroupId to{};
  bool by_need = false;
  bool mandatory = false, optional = false; ///< levels of a request; a need is neither
  Span span{};
  Region region;
};

std::vector<Branch> branches_of(const Model& model, GroupId group, const std::function<bool(ProviderId)>& counts) {
  std::vector<Branch> out;
  for (const ProviderId id : model.groups[group].providers) {
    if (!counts(id)) continue;
    const Provider& provider = model.providers[id];
    const Region region = active_region(model, provider);
    for (const Use<GroupId>& need : provider.needs) out.push_back({need.id, true, false, false, need.span, region});
    for (const Pack& pack : provider.packs) {
      for (const Task& task : pack.tasks) {
        Branch branch{task.target, false, false, false, task.span, region};
        for (const Task::NamedLevel& level : task.levels)
          (model.edges[task.edge].levels[level.level].optional ? branch.optional : branch.mandatory) = true;
        out.push_back(std::move(branch));
      }
    }
  }
  return out;
}

/// Where some provider of the group that counts can be active.
Region grantable_region(const Model& model, GroupId group, const std::function<bool(ProviderId)>& counts) {
  std::optional<Region> out;
  for (const ProviderId id : model.groups[group].providers) {
    if (!counts(id)) continue;
    const Region region = active_region(model, model.providers[id]);
    out = out ? hull(*out, region) : region;
  }
  return out.value_or(Region{});
}

} // namespace

Claims::Claims(const Model& model, GroupId task, const std::function<bool(ProviderId)>& counts,
               const std::vector<GroupId>& without) {
  for (auto& table : claims_) table = IdTable<GroupId, std::optional<Claim>>(model.groups.size());
  IdTable<GroupId, std::optional<std::vector<Branch>>> branches(model.groups.size());
  IdTable<GroupId, std::optional<Region>> grantable(model.groups.size());
  const auto region_at = [&](GroupId group) -> const Region& {
    if (!grantable[group]) grantable[group] = grantable_region(model, group, counts);
    return *grantable[group];
  };
  std::deque<std::pair<GroupId, Reach>> open;

  // First in, first out: the first way to a group is a shortest one. A group whose region grows is gone through again.
  claims_[0][task] = Claim{region_at(task), {}, false, {}, Reach::own, 0};
  open.emplace_back(task, Reach::own);
  while (!open.empty()) {
    const auto [group, reach] = open.front();
    open.pop_front();
    if (!branches[group]) branches[group] = branches_of(model, group, counts);
    const Claim here = *claims_[static_cast<std::size_t>(reach)][group];
    const auto go = [&](const Branch& branch, Reach next) {
      Region region = here.region;
      region.meet(branch.region);
      region.meet(region_at(branch.to));
      if (region.empty()) return;
      std::optional<Claim>& there = claims_[static_cast<std::size_t>(next)][branch.to];
      if (!there) {
        there = Claim{std::move(region), {group}, branch.by_need, branch.span, reach, here.steps + 1};
        open.emplace_back(branch.to, next);
        return;
      }
      if (std::find(there->from.begin(), there->from.end(), group) == there->from.end()) there->from.push_back(group);
      Region more = hull(there->region, region);
      if (more.states == there->region.states) return;
      there->region = std::move(more);
      open.emplace_back(branch.to, next);
    };
    for (const Branch& branch : *branches[group]) {
      if (branch.to == group || std::find(without.begin(), without.end(), branch.to) != without.end()) continue;
      if (branch.by_need) go(branch, reach);
      if (branch.mandatory) go(branch, reach == Reach::optional ? Reach::optional : Reach::mandatory);
      if (branch.optional) go(branch, Reach::optional);
    }
  }
}

std::vector<ClaimStep> Claims::path(GroupId group, Reach reach) const {
  std::vector<ClaimStep> out;
  // Ends at the task itself, also where needs lead back to it.
  for (const Claim* claim = find(group, reach); claim != nullptr && claim->steps > 0;) {
    const GroupId from = claim->from.front();
    out.push_back({from, group, claim->by_need, claim->span});
    group = from;
    claim = find(group, reach = claim->reach_from);
  }
  std::reverse(out.begin(), out.end());
  return out;
}

} // namespace director::checks
