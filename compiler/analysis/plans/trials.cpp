// Header: compiler/analysis/plans/trials.hpp. Test: tests/compiler/analysis/plans/trials_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/plans/trials.hpp"

#include "compiler/graph/clusters.hpp"
#include "compiler/graph/components.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace director::analysis {

namespace {

constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();

void add(TrialCount& to, const TrialCount& more, std::int64_t times = 1) {
  const std::int64_t count = more.count > most / times ? most : more.count * times;
  to.count = to.count > most - count ? most : to.count + count;
  to.complete = to.complete && more.complete;
}

void multiply(TrialCount& to, const TrialCount& factor) {
  const std::int64_t count = std::max<std::int64_t>(factor.count, 1);
  to.count = to.count > most / count ? most : to.count * count;
  to.complete = to.complete && factor.complete;
}

} // namespace

Trials::Trials(const Model& model, std::int64_t most_plans, Budget& budget)
    : model_(model),
      most_plans_(most_plans),
      budget_(budget),
      clusters_(find_clusters(model)),
      components_(find_components(model)),
      ways_(model.groups.size()) {}

CountedUnit Trials::alone(const Task& task) const { return {{&task}, {{&task}}}; }

CountedUnit Trials::together(const Pack& pack) const {
  CountedUnit out;
  for (const Task& task : pack.tasks) {
    if (model_.may_be_member(task)) out.members.push_back(&task);
  }
  std::map<EdgeId, std::size_t> place;
  for (const Task* member : out.members) {
    const auto [at, is_new] = place.try_emplace(clusters_[member->edge], out.colliding.size());
    if (is_new) out.colliding.emplace_back();
    out.colliding[at->second].push_back(member);
  }
  return out;
}

const TrialCount& Trials::ways(GroupId group) {
  std::optional<TrialCount>& out = ways_[group];
  if (out) return *out;
  out = TrialCount{};
  for (const ProviderId provider : model_.groups[group].providers) {
    const PlanCount found = plans(provider);
    add(*out, {found.tried(), found.complete});
  }
  return *out;
}

PlanCount Trials::plans(ProviderId provider) { return count_plans(model_, provider, most_plans_, budget_); }

TrialCount Trials::product(const std::vector<const Task*>& members) {
  TrialCount out{1, true};
  for (const Task* member : members) multiply(out, ways(member->target));
  return out;
}

TrialCount Trials::ways(const CountedUnit& unit) {
  TrialCount out;
  for (const std::vector<const Task*>& members : unit.colliding) {
    const TrialCount product_of = product(members);
    out.count = std::max(out.count, product_of.count);
    out.complete = out.complete && product_of.complete;
  }
  return out;
}

TrialCount Trials::decision(const CountedUnit& unit) {
  TrialCount out;
  if (unit.members.size() == 1) return ways(unit.members.front()->target);
  // One after the other, up to the first that has no choice beside those before it; and each by itself. Then those that
  // can claim the same group, in all combinations.
  for (const Task* member : unit.members) add(out, ways(member->target), 2);
  if (unit.colliding.size() == unit.members.size()) return out;
  for (const std::vector<const Task*>& members : unit.colliding) add(out, product(members));
  return out;
}

TrialCount Trials::pass(const Pack& pack) {
  TrialCount out;
  for (const Task& task : pack.tasks) add(out, ways(task.target), 2);
  if (const CountedUnit unit = together(pack); !unit.members.empty()) add(out, decision(unit), 2);
  return out;
}

TrialCount Trials::pass(const Task& root) {
  TrialCount out;
  add(out, ways(root.target), 2);
  return out;
}

LargestPack Trials::pass(GroupId group) {
  LargestPack out;
  for (const ProviderId id : model_.groups[group].providers) {
    for (const Pack& pack : model_.providers[id].packs) {
      if (const TrialCount count = pass(pack); count.count > out.count.count) out = {count, id};
    }
  }
  return out;
}

std::vector<PassTrials> Trials::passes() {
  std::vector<PassTrials> out;
  for (const GroupId group : model_.groups.ids()) out.resize(std::max<std::size_t>(out.size(), component(group) + 1));
  const auto add_share = [&](GroupId group, const PassTrials::Share& share) {
    PassTrials& to = out[component(group)];
    add(to.sum, share.count);
    to.shares.push_back(share);
  };
  for (const Task& root : model_.roots) add_share(root.target, {pass(root), &root, {}});
  for (const GroupId group : model_.groups.ids()) {
    if (const LargestPack largest = pass(group); largest.count.count > 0)
      add_share(group, {largest.count, nullptr, largest.provider});
  }
  return out;
}

} // namespace director::analysis
