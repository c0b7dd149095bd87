// Header: compiler/analysis/needs/units.hpp. Test: tests/compiler/analysis/needs/units_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/needs/units.hpp"

#include "compiler/analysis/chains/sparse_set.hpp"
#include "compiler/analysis/plans/choices.hpp"
#include "compiler/model/closure.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace director::analysis {

namespace {

/// In units of the run's budget: each pick copies a region.
constexpr std::int64_t unit_step_cost = 20;

/// The current choice, with the region of its conditions.
class Combining {
public:
  Combining(const Model& model, const Facts& facts, bool by_groups_alone,
            const std::function<bool(const Combination&)>& visitor)
      : model_(model),
        facts_(facts),
        by_groups_alone_(by_groups_alone),
        visitor_(visitor) {}

  bool pick(ProviderId provider) {
    Region both = now_.region;
    both.meet(facts_.region_to_run(model_, provider, true));
    if (!by_groups_alone_ && both.empty()) return false;
    now_.picks.push_back({model_.providers[provider].group, provider});
    before_.push_back(std::exchange(now_.region, std::move(both)));
    return true;
  }
  void drop() {
    now_.picks.pop_back();
    now_.region = std::move(before_.back());
    before_.pop_back();
  }
  void dead_end() const {}
  /// A provider without a plan is reported by another check; here it is assumed to need nothing.
  bool leave_needs(ProviderId provider) const { return facts_.plans[provider] != PlanVerdict::found; }
  bool complete() const { return visitor_(now_); }

private:
  const Model& model_;
  const Facts& facts_;
  bool by_groups_alone_;
  const std::function<bool(const Combination&)>& visitor_;
  Combination now_;
  std::vector<Region> before_; ///< for each pick
};

} // namespace

std::vector<const Task*> unit_members(const Model& model, const Pack& pack) {
  std::vector<const Task*> out;
  for (const Task& task : pack.tasks) {
    if (model.is_always_member(task)) out.push_back(&task);
  }
  return out;
}

const std::vector<GroupId>& Units::needed(GroupId group) {
  const auto [at, is_new] = needed_.try_emplace(group);
  std::vector<GroupId>& out = at->second;
  if (!is_new) return out;
  out.push_back(group);
  add_needed(model_, out);
  std::sort(out.begin(), out.end());
  return out;
}

Region Units::region_at_best(GroupId group) {
  const auto [at, is_new] = regions_.try_emplace(group); // in a cycle of needs: anywhere
  if (!is_new) return at->second;
  std::optional<Region> out;
  for (const ProviderId id : model_.groups[group].providers) {
    Region region = facts_.region_to_run(model_, id, true);
    for (const Use<GroupId>& need : model_.providers[id].needs) region.meet(region_at_best(need.id));
    out = out ? hull(*out, region) : region;
  }
  return regions_[group] = out.value_or(Region{});
}

bool Units::may_clash(const std::vector<GroupId>& members) {
  SparseSet<GroupId> groups;
  std::set<StateId> states;
  for (const GroupId member : members) {
    std::set<StateId> own;
    for (const GroupId group : needed(member)) {
      if (!groups.add(group)) return true;
      for (const ProviderId id : model_.groups[group].providers) {
        for (const auto& [state, values] : facts_.region_to_run(model_, id, true).states) own.insert(state);
      }
    }
    for (const StateId state : own) {
      if (!states.insert(state).second) return true;
    }
  }
  return false;
}

UnitVerdict Units::verdict(const std::vector<GroupId>& members, bool by_groups_alone) {
  if (!may_clash(members)) return UnitVerdict::possible;
  bool found = false;
  const bool complete = visit(members, by_groups_alone, [&](const Combination&) {
    found = true;
    return false;
  });
  return found ? UnitVerdict::possible : complete ? UnitVerdict::impossible : UnitVerdict::undecided;
}

bool Units::visit(const std::vector<GroupId>& members, bool by_groups_alone,
                  const std::function<bool(const Combination&)>& visitor) {
  std::vector<Use<GroupId>> needs;
  for (const GroupId member : members) needs.push_back({member, {}});
  Combining combining(model_, facts_, by_groups_alone, visitor);
  const std::int64_t granted = budget_.grant(most_steps * unit_step_cost) / unit_step_cost;
  ChoiceSearch search(model_, granted, combining);
  const bool complete = search.run(needs);
  budget_.spend((granted - search.steps_left()) * unit_step_cost);
  return complete;
}

} // namespace director::analysis
