// Header: compiler/analysis/conflicts/kept_while_requested.hpp. Test: compiler/checks/push_in_vain.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/kept_while_requested.hpp"

#include "compiler/analysis/clashes/losses.hpp"
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/requests/company.hpp"
#include "compiler/analysis/shared/shared.hpp"

#include <set>
#include <utility>

namespace director::analysis {

namespace {

class KeptSearch {
public:
  explicit KeptSearch(const Input& input)
      : input_(input),
        model_(input.model),
        losses_(input.model, input.graph, input.facts, input.shared) {
    for (const Clash& clash : input.conflicts.clashes()) seen_.insert(clash.second.span);
    for (const Loser& loser : input.conflicts.losers()) starving_.insert({loser.above, loser.refused.task->target});
  }

  void look_at(const Wanting& wanting) {
    for (const Want& want : wanting.wants) {
      if (want.waiter != wanting.provider || seen_.count(want.condition.span) != 0) continue;
      for (const Request& request : input_.shared.requests().of(wanting.task)) {
        if (!request.requester ||
            input_.shared.indispensable().needs_contain(model_.providers[*request.requester], wanting.task))
          continue;
        const std::vector<KeptNeed> kept = find_kept_needs(model_, input_.shared, *request.requester, want.causers);
        if (kept.empty() || !waits_here(request, want)) continue;
        seen_.insert(want.condition.span);
        found_.push_back({request, want, kept.front()});
        break;
      }
    }
  }

  std::vector<KeptWhileRequested> take() { return std::move(found_); }

private:
  /// Whether it waits there for what only these cause, and one of them is requested: otherwise that is the finding.
  bool waits_here(const Request& request, const Want& want) const {
    std::vector<GroupId> groups;
    for (const ProviderId id : want.causers) {
      const GroupId group = model_.providers[id].group;
      if (input_.shared.promises().explained.contains(id) || starving_.count({*request.requester, group}) != 0)
        return false;
      groups.push_back(group);
    }
    if (losses_.comes_otherwise(want) ||
        !input_.shared.standstill().may_wait(request, want.waiter, want.condition, groups))
      return false;
    return !need_not_be_requested(model_, input_.facts, input_.shared.requests(), request, groups);
  }

  const Input& input_;
  const Model& model_;
  const Losses losses_;
  std::set<dsl::Span> seen_;                          ///< conditions with a finding
  std::set<std::pair<ProviderId, GroupId>> starving_; ///< groups that never run below this provider (self_conflict)
  std::vector<KeptWhileRequested> found_;
};

} // namespace

std::vector<KeptWhileRequested> find_kept_while_requested(const Input& input) {
  KeptSearch search(input);
  for (const Wanting& wanting : input.shared.wants()) search.look_at(wanting);
  return search.take();
}

} // namespace director::analysis
