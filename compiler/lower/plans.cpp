// Header: compiler/lower/plans.hpp. Test: tests/compiler/lower/plans_test.cpp.
// SPDX-License-Identifier: MIT
//
// Whether a provider occurs in a valid plan is as hard as whether there is one (choosing disjoint providers is
// NP-complete), so plans are tried in order, and the search ends as soon as every possible provider has been seen.
// Mostly that takes as many plans as the group with the most alternatives has.

#include "compiler/lower/plans.hpp"

#include "compiler/model/closure.hpp"

#include <set>

namespace director::compiler {

namespace {

class PlanSearch {
public:
  PlanSearch(const Model& model, ProviderId provider, std::size_t most_steps)
      : model_(model),
        steps_left_(most_steps),
        used_(model.groups.size(), false) {
    std::vector<GroupId> needed;
    for (const Use<GroupId>& need : model.providers[provider].needs) needed.push_back(need.id);
    add_needed(model, needed);
    for (const GroupId group : needed) {
      if (group == model.providers[provider].group) continue;
      for (const ProviderId each : model.groups[group].providers) possible_.insert(each);
    }
    used_[model.providers[provider].group] = true;
    meet_needs(provider, nullptr);
  }

  PlanProviders result() const {
    const bool exact = steps_left_ > 0 || seen_.size() == possible_.size();
    const std::set<ProviderId>& found = exact ? seen_ : possible_;
    return {{found.begin(), found.end()}, exact};
  }

private:
  /// A need that is not met yet, and those after it.
  struct Open {
    GroupId group{};
    const Open* rest = nullptr;
  };

  /// First the needs of this provider, then the rest: depth first.
  void meet_needs(ProviderId provider, const Open* rest) {
    const std::vector<Use<GroupId>>& needs = model_.providers[provider].needs;
    std::vector<Open> open(needs.size());
    for (std::size_t i = needs.size(); i-- > 0;) {
      open[i] = {needs[i].id, rest};
      rest = &open[i];
    }
    meet(rest);
  }

  void meet(const Open* open) {
    if (steps_left_ == 0 || seen_.size() == possible_.size()) return;
    --steps_left_;
    if (open == nullptr) {
      seen_.insert(picked_.begin(), picked_.end());
      return;
    }
    if (used_[open->group]) return; // a group cannot be held for two purposes
    used_[open->group] = true;
    for (const ProviderId provider : model_.groups[open->group].providers) {
      picked_.push_back(provider);
      meet_needs(provider, open->rest);
      picked_.pop_back();
    }
    used_[open->group] = false;
  }

  const Model& model_;
  std::size_t steps_left_;
  IdTable<GroupId, char> used_;
  std::set<ProviderId> possible_, seen_;
  std::vector<ProviderId> picked_;
};

} // namespace

PlanProviders providers_in_plans(const Model& model, ProviderId provider, std::size_t most_steps) {
  return PlanSearch(model, provider, most_steps).result();
}

} // namespace director::compiler
