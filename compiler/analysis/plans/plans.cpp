// Header: compiler/analysis/plans/plans.hpp. Test: tests/compiler/analysis/plans/plans_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/plans/plans.hpp"

#include "compiler/analysis/plans/choices.hpp"
#include "compiler/graph/algorithms.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace director::analysis {

namespace {

/// In units of the run's budget: picking a provider takes longer than checking a condition.
constexpr std::int64_t plan_step_cost = 4;

class PlanCounter {
public:
  PlanCounter(std::int64_t most, bool find_only, const IdSet<ProviderId>* mended)
      : most_(most),
        find_only_(find_only),
        mended_(mended) {}

  bool pick(ProviderId) const { return !ended(); }
  void drop() const {}
  void dead_end() { ++count_.dead_ends; }
  bool leave_needs(ProviderId provider) const { return mended_ != nullptr && mended_->contains(provider); }
  bool complete() {
    ++count_.plans;
    return !ended();
  }

  PlanCount count(bool finished) const { return {count_.plans, count_.dead_ends, finished && !ended()}; }

private:
  bool ended() const { return find_only_ ? count_.plans != 0 : count_.tried() >= most_; }

  std::int64_t most_;
  bool find_only_; ///< end with the first plan, however many beginnings lead nowhere
  const IdSet<ProviderId>* mended_;
  PlanCount count_;
};

PlanCount count(const Model& model, ProviderId provider, PlanCounter counter, Budget& budget) {
  const std::int64_t granted = budget.grant(plan_steps * plan_step_cost) / plan_step_cost;
  ChoiceSearch search(model, granted, counter);
  search.hold(model.providers[provider].group);
  const bool finished = search.run(model.providers[provider].needs);
  budget.spend((granted - search.steps_left()) * plan_step_cost);
  return counter.count(finished);
}

using Parts = std::optional<std::vector<GroupId>>; ///< sorted; empty optional: all groups

/// What is indispensable for one provider: what all ways to meet its needs have in common.
Parts by_provider(const Provider& provider, const IdTable<GroupId, Parts>& parts) {
  std::vector<GroupId> out;
  for (const Use<GroupId>& need : provider.needs) {
    const Parts& more = parts[need.id];
    if (!more) return std::nullopt;
    std::vector<GroupId> both;
    std::set_union(out.begin(), out.end(), more->begin(), more->end(), std::back_inserter(both));
    out = std::move(both);
  }
  return out;
}

Parts intersected(Parts a, Parts b) {
  if (!a) return b;
  if (!b) return a;
  std::vector<GroupId> out;
  std::set_intersection(a->begin(), a->end(), b->begin(), b->end(), std::back_inserter(out));
  return out;
}

} // namespace

PlanCount count_plans(const Model& model, ProviderId provider, std::int64_t most, Budget& budget) {
  return count(model, provider, PlanCounter(most, false, nullptr), budget);
}

PlanVerdict find_plan(const Model& model, ProviderId provider, Budget& budget, const IdSet<ProviderId>* mended) {
  if (model.providers[provider].needs.empty()) return PlanVerdict::found;
  const PlanCount one = count(model, provider, PlanCounter(1, true, mended), budget);
  if (one.plans > 0) return PlanVerdict::found;
  return one.complete ? PlanVerdict::none : PlanVerdict::undecided;
}

Indispensable::Indispensable(const Model& model, const IdSet<ProviderId>* counts) : parts_(model.groups.size()) {
  Arrows needs(model.groups.size());
  for (const Edge& edge : model.edges) {
    if (edge.needed) needs[edge.requester->value].push_back(edge.target.value);
  }
  const std::vector<Node> order = topological_order(needs);
  // A greatest fixed point: begin with everything and remove what some provider does not use. Needed groups come first,
  // so one round is enough without cycles, and a second one confirms it.
  for (bool changed = true; changed;) {
    changed = false;
    for (auto node = order.rbegin(); node != order.rend(); ++node) {
      const GroupId group{*node};
      Parts both;
      for (const ProviderId provider : model.groups[group].providers) {
        if (counts == nullptr || counts->contains(provider))
          both = intersected(std::move(both), by_provider(model.providers[provider], parts_));
      }
      if (both && !std::binary_search(both->begin(), both->end(), group))
        both->insert(std::upper_bound(both->begin(), both->end(), group), group);
      if (both == parts_[group]) continue;
      parts_[group] = std::move(both);
      changed = true;
    }
  }
}

std::vector<GroupId> Indispensable::in_common(GroupId a, GroupId b) const {
  if (!parts_[a] || !parts_[b]) return {};
  return *intersected(parts_[a], parts_[b]);
}

bool Indispensable::contains(GroupId group, GroupId part) const {
  const Parts& parts = parts_[group];
  return !parts || std::binary_search(parts->begin(), parts->end(), part);
}

bool Indispensable::needs_contain(const compiler::Provider& provider, GroupId part) const {
  return std::any_of(provider.needs.begin(), provider.needs.end(),
                     [&](const Use<GroupId>& need) { return contains(need.id, part); });
}

bool Indispensable::needs_part_of(const compiler::Provider& provider, GroupId group) const {
  const auto& parts = of(group);
  return parts &&
         std::any_of(parts->begin(), parts->end(), [&](GroupId part) { return needs_contain(provider, part); });
}

} // namespace director::analysis
