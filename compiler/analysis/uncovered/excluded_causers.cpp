// Header: compiler/analysis/uncovered/excluded_causers.hpp. Test: compiler/checks/push_in_vain.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/uncovered/excluded_causers.hpp"

#include "compiler/analysis/clashes/losses.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/facts/waiting.hpp"
#include "compiler/analysis/requests/company.hpp"
#include "compiler/analysis/shared/shared.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace director::analysis {

namespace {

class ExcludedSearch {
public:
  explicit ExcludedSearch(const Input& input)
      : input_(input),
        model_(input.model),
        exclusion_(input.shared.push_exclusion()),
        waiting_(input.model, input.facts),
        losses_(input.model, input.graph, input.facts, input.shared) {
    for (const Clash& clash : input.conflicts.clashes()) seen_.insert(clash.second.span);
  }

  void look_at(GroupId task) {
    if (!waiting_.may_wait(task)) return;
    for (const ProviderId waiter : model_.groups[task].providers) {
      if (!input_.facts.capable.contains(waiter) || !waiting_.may_be_first(waiter)) continue;
      for (const ConditionUse& use : model_.providers[waiter].when) look_at(task, waiter, use);
    }
  }

  std::vector<ExcludedCausers> take() { return std::move(found_); }

private:
  using Excluded = ExcludedCausers::Excluded;

  void look_at(GroupId task, ProviderId waiter, const ConditionUse& use) {
    if (seen_.count(use.span) != 0 || input_.facts.is_impossible(waiter, model_.conditions[use.id].state)) return;
    Want want{waiter, use, {}};
    for (const ProviderId causer : input_.shared.causers()[use.id]) {
      const GroupId group = model_.providers[causer].group;
      if (group == task || !input_.facts.active.contains(causer)) continue;
      if (!input_.shared.chains().may_beat(task, group)) return;
      want.causers.push_back(causer);
    }
    if (want.causers.empty() || losses_.comes_otherwise(want)) return;
    for (const Request& request : input_.shared.requests().of(task)) {
      for (const Region& region : input_.shared.requests().regions(request)) {
        if (look_at(want, request, region)) return;
      }
    }
  }

  bool look_at(const Want& want, const Request& request, const Region& region) {
    std::vector<Excluded> all;
    std::vector<GroupId> groups, absent;
    for (const ProviderId causer : want.causers) {
      const std::optional<Excluded> one = find_excluded(want.waiter, region, causer);
      if (!one) return false;
      all.push_back(*one);
      groups.push_back(model_.providers[causer].group);
      if (one->unrequested || none_can_run(groups.back(), want.waiter, region)) absent.push_back(groups.back());
    }
    if (!input_.shared.standstill().may_wait(region, want.waiter, want.condition, absent) ||
        need_not_be_requested(model_, input_.facts, input_.shared.requests(), request, groups))
      return false;
    found_.push_back({want, request, region, std::move(all)});
    return true;
  }

  bool none_can_run(GroupId group, ProviderId waiter, const Region& region) const {
    const std::vector<ProviderId>& providers = model_.groups[group].providers;
    return std::all_of(providers.begin(), providers.end(), [&](ProviderId id) {
      return !input_.facts.active.contains(id) || exclusion_.find_outside(waiter, region, id, Region{});
    });
  }

  std::optional<Excluded> find_excluded(ProviderId waiter, const Region& region, ProviderId causer) const {
    if (const auto state = exclusion_.find_outside(waiter, region, causer, Region{})) return Excluded{causer, *state};
    std::optional<StateId> first;
    for (const Request& request : input_.shared.requests().of(model_.providers[causer].group)) {
      for (const Region& requested : input_.shared.requests().regions(request)) {
        const auto state = exclusion_.find_outside(waiter, region, causer, requested);
        if (!state) return std::nullopt;
        if (!first) first = state;
      }
    }
    if (!first) return std::nullopt;
    return Excluded{causer, *first, true};
  }

  const Input& input_;
  const Model& model_;
  const PushExclusion& exclusion_;
  Waiting waiting_;
  const Losses losses_;
  std::set<dsl::Span> seen_; ///< conditions with a finding
  std::vector<ExcludedCausers> found_;
};

} // namespace

std::vector<ExcludedCausers> find_excluded_causers(const Input& input) {
  ExcludedSearch search(input);
  for (const GroupId task : input.model.groups.ids()) {
    if (input.facts.requested.contains(task)) search.look_at(task);
  }
  return search.take();
}

} // namespace director::analysis
