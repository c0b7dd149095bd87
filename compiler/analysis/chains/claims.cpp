// Header: compiler/analysis/chains/claims.hpp. Test: compiler/checks/equal_priority.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/chains/claims.hpp"

#include <algorithm>
#include <deque>
#include <iterator>
#include <utility>

namespace director::analysis {

namespace {

using Counted = Branches::Counted;

Region counted_region(const Model& model, const Counted& counted, ProviderId id) {
  Region out = active_region(model, model.providers[id]);
  if (counted.is_pushed && counted.is_pushed(id)) {
    for (const ConditionUse& promise : model.providers[id].causing)
      out.states.erase(model.conditions[promise.id].state);
  }
  return out;
}

bool is_counted(const Counted& counted, ProviderId id) { return counted.runs(id) || counted.is_picked(id); }

/// The states with which a counted provider of this kind can be active; nothing: there is none.
template <class Kind>
std::optional<Region> active_in(const Model& model, const Counted& counted, GroupId group, Kind is_of_kind) {
  std::optional<Region> out;
  for (const ProviderId id : model.groups[group].providers) {
    if (!is_counted(counted, id) || !is_of_kind(id)) continue;
    const Region region = counted_region(model, counted, id);
    out = out ? hull(*out, region) : region;
  }
  return out;
}

Branch request_of(const Model& model, const Task& task) {
  Branch out{task.target, false, false, false, false, task.span, {}};
  for (const Task::NamedLevel& level : task.levels)
    (model.edges[task.edge].levels[level.level].optional ? out.optional : out.mandatory) = true;
  return out;
}

/// Whichever provider is active: with each it leads on; with those that do not need what it requests, it holds that.
void add_request_of_group(const Model& model, const Counted& counted, GroupId group, Branch branch,
                          std::vector<Branch>& out) {
  const auto needs = [&](ProviderId id) { return model.providers[id].needs_group(branch.to); };
  branch.needed_too = active_in(model, counted, group, needs).has_value();
  out.push_back(branch);
  if (!branch.needed_too) return;
  std::optional<Region> alone = active_in(model, counted, group, [&](ProviderId id) { return !needs(id); });
  if (!alone) return;
  branch.needed_too = false;
  branch.region = std::move(*alone);
  out.push_back(std::move(branch));
}

void add_needs(const Provider& provider, const Region& region, std::vector<Branch>& out) {
  for (const Use<GroupId>& need : provider.needs)
    out.push_back({need.id, true, false, false, false, need.span, region});
}

void add_requests(const Model& model, const Counted& counted, const Provider& provider, const Pack& pack,
                  const Region& region, std::vector<Branch>& out) {
  for (const Task& task : pack.tasks) {
    Branch branch = request_of(model, task);
    if (counted.requested == Requested::by_group) {
      add_request_of_group(model, counted, provider.group, std::move(branch), out);
      continue;
    }
    branch.needed_too = provider.needs_group(task.target);
    branch.region = region;
    out.push_back(std::move(branch));
  }
}

/// A group that is only needed holds its own needs, and requests nothing.
std::vector<Branch> branches_of(const Model& model, const Counted& counted, GroupId group) {
  std::vector<Branch> out;
  for (const ProviderId id : model.groups[group].providers) {
    if (!is_counted(counted, id)) continue;
    const Provider& provider = model.providers[id];
    const Region region = counted_region(model, counted, id);
    add_needs(provider, region, out);
    if (!counted.runs(id)) continue;
    for (const Pack& pack : provider.packs) add_requests(model, counted, provider, pack, region, out);
  }
  return out;
}

} // namespace

Branches::Branches(const Model& model, Counted counted)
    : model_(model),
      counted_(std::move(counted)),
      from_(model.groups.size()),
      grantable_(model.groups.size()) {}

Branches::Branches(const Model& model, Counted counted, Only only)
    : model_(model),
      counted_(std::move(counted)),
      only_(std::move(only)) {}

Branches Branches::with(ProviderId id, const Pack* pack) const {
  const Provider& provider = model_.providers[id];
  Only only{*this, provider.group, {}, counted_region(model_, counted_, id)};
  add_needs(provider, only.grantable, only.from);
  if (pack != nullptr) add_requests(model_, counted_, provider, *pack, only.grantable, only.from);
  return Branches(model_, counted_, std::move(only));
}

const std::vector<Branch>& Branches::from(GroupId group) const {
  if (only_) return group == only_->group ? only_->from : only_->all.from(group);
  if (!from_[group]) from_[group] = branches_of(model_, counted_, group);
  return *from_[group];
}

const Region& Branches::grantable(GroupId group) const {
  if (only_) return group == only_->group ? only_->grantable : only_->all.grantable(group);
  if (!grantable_[group])
    grantable_[group] = active_in(model_, counted_, group, [](ProviderId) { return true; }).value_or(Region{});
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
      if (branches.requested() == Requested::by_group) add_held(branch, next, is_new ? nullptr : &there, region);
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

/// Called before the claim grows; `before`: null if it is new.
void Claims::add_held(const Branch& branch, Reach reach, const Claim* before, const Region& region) {
  const std::pair key{reach, branch.to};
  auto at = held_.find(key);
  if (at == held_.end()) {
    if (!branch.needed_too) return;
    at = held_.try_emplace(key).first;
    if (before != nullptr) at->second = before->region;
  }
  if (!branch.needed_too) at->second = at->second ? hull(*at->second, region) : region;
}

const Region& Claims::held_region(GroupId group, Reach reach) const {
  const auto at = held_.find({reach, group});
  return at != held_.end() && at->second ? *at->second : on_path(group, reach)->region;
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

const Claims& ClaimsCache::of(GroupId task) const {
  std::unique_ptr<const Claims>& claims = claims_[task];
  if (!claims) claims = std::make_unique<const Claims>(branches_, task);
  return *claims;
}

} // namespace director::analysis
