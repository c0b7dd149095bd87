// Header: compiler/analysis/chains/claims.hpp. Test: compiler/checks/equal_priority.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/chains/claims.hpp"

#include <algorithm>
#include <deque>
#include <iterator>
#include <utility>

namespace director::analysis {

namespace {

using Filter = Branches::Filter;

/// A group that is only needed holds its own needs, and requests nothing.
std::vector<Branch> branches_of(const Model& model, GroupId group, const Filter& runs, const Filter& is_picked) {
  std::vector<Branch> out;
  for (const ProviderId id : model.groups[group].providers) {
    const bool may_run = runs(id);
    if (!may_run && !is_picked(id)) continue;
    const Provider& provider = model.providers[id];
    const Region region = active_region(model, provider);
    for (const Use<GroupId>& need : provider.needs)
      out.push_back({need.id, true, false, false, false, need.span, region});
    if (!may_run) continue;
    for (const Pack& pack : provider.packs) {
      for (const Task& task : pack.tasks) {
        Branch branch{task.target, false, false, false, provider.needs_group(task.target), task.span, region};
        for (const Task::NamedLevel& level : task.levels)
          (model.edges[task.edge].levels[level.level].optional ? branch.optional : branch.mandatory) = true;
        out.push_back(std::move(branch));
      }
    }
  }
  return out;
}

/// The states with which some counted provider of the group can be active.
Region grantable_region(const Model& model, GroupId group, const Filter& runs, const Filter& is_picked) {
  std::optional<Region> out;
  for (const ProviderId id : model.groups[group].providers) {
    if (!runs(id) && !is_picked(id)) continue;
    const Region region = active_region(model, model.providers[id]);
    out = out ? hull(*out, region) : region;
  }
  return out.value_or(Region{});
}

} // namespace

Branches::Branches(const Model& model, Filter runs, Filter is_picked)
    : model_(model),
      runs_(std::move(runs)),
      is_picked_(std::move(is_picked)),
      from_(model.groups.size()),
      grantable_(model.groups.size()) {}

const std::vector<Branch>& Branches::from(GroupId group) const {
  if (!from_[group]) from_[group] = branches_of(model_, group, runs_, is_picked_);
  return *from_[group];
}

const Region& Branches::grantable(GroupId group) const {
  if (!grantable_[group]) grantable_[group] = grantable_region(model_, group, runs_, is_picked_);
  return *grantable_[group];
}

Claims::Claims(const Branches& branches, GroupId task, const std::vector<GroupId>& without, const Enough& enough) {
  std::deque<std::pair<GroupId, Reach>> open;

  // Breadth first: the first path to a group is a shortest one. A group whose region grows is visited again.
  claims_[0].emplace(task, Claim{branches.grantable(task), 0, {}, LastStep{}});
  open.emplace_back(task, Reach::own);
  bool ended = enough && enough(task, Reach::own, claims_[0].at(task));
  while (!open.empty() && !ended) {
    const auto [group, reach] = open.front();
    open.pop_front();
    const Claim here = *on_path(group, reach); // a copy: it may grow if a cycle leads back here
    const auto go = [&](const Branch& branch, Reach next) {
      ++effort_;
      Region region = here.region;
      region.meet(branch.region);
      region.meet(branches.grantable(branch.to));
      if (region.empty()) return;
      const LastStep last{{group, branch.to, branch.by_need, branch.span}, reach};
      const auto [at, is_new] = claims_[static_cast<std::size_t>(next)].try_emplace(branch.to);
      Claim& there = at->second;
      if (is_new) there = Claim{{}, here.steps + 1, last, {}};
      const bool is_held_now = !branch.needed_too && !there.held;
      if (is_held_now) there.held = last;
      Region more = is_new ? std::move(region) : hull(there.region, region);
      const bool grows = is_new || more.states != there.region.states;
      if (!grows && !is_held_now) return;
      there.region = std::move(more);
      if (grows) open.emplace_back(branch.to, next);
      ended = ended || (there.held && enough && enough(branch.to, next, there));
    };
    for (const Branch& branch : branches.from(group)) {
      if (branch.to == group || std::find(without.begin(), without.end(), branch.to) != without.end()) continue;
      if (branch.by_need) go(branch, reach);
      if (branch.mandatory) go(branch, reach == Reach::optional ? Reach::optional : Reach::mandatory);
      if (branch.optional) go(branch, Reach::optional);
    }
  }

  for (const auto& claims : claims_) {
    for (const auto& [group, claim] : claims) groups_.push_back(group);
  }
  std::sort(groups_.begin(), groups_.end());
  groups_.erase(std::unique(groups_.begin(), groups_.end()), groups_.end());
}

std::vector<ChainStep> Claims::path(GroupId group, Reach reach) const {
  std::vector<ChainStep> out;
  // Ends at the task itself, even if needs lead back to it.
  for (const Claim* claim = on_path(group, reach); claim != nullptr && claim->steps > 0;) {
    const auto& [step, reach_from] = out.empty() && claim->held ? *claim->held : claim->last;
    out.push_back(step);
    claim = on_path(step.from, reach_from);
  }
  std::reverse(out.begin(), out.end());
  return out;
}

std::vector<ChainStep> Claims::path(GroupId group) const {
  const auto reach =
      std::find_if(std::begin(all_reaches), std::end(all_reaches), [&](Reach each) { return find(group, each); });
  return reach == std::end(all_reaches) ? std::vector<ChainStep>{} : path(group, *reach);
}

} // namespace director::analysis
