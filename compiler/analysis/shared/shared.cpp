// Header: compiler/analysis/shared/shared.hpp. Test: tests/compiler/checks/pages_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/shared/shared.hpp"

#include <algorithm>

namespace director::analysis {

const Chains& Shared::chains() const {
  if (!chains_) chains_.emplace(model_, [this](ProviderId id) { return is_active(id); });
  return *chains_;
}

const Promises& Shared::promises() const {
  if (!promises_) promises_ = find_promises(model_, graph_, facts_, chains());
  return *promises_;
}

const Decisions& Shared::decisions() const {
  if (!decisions_) decisions_ = find_decisions(model_, facts_, Reported::corrected, budget_);
  return *decisions_;
}

const Requests& Shared::requests() const {
  if (!requests_) requests_.emplace(model_, graph_, facts_);
  return *requests_;
}

const Causers& Shared::causers() const {
  if (!causers_) causers_ = find_causers(model_);
  return *causers_;
}

const PushExclusion& Shared::push_exclusion() const {
  if (!push_exclusion_) push_exclusion_.emplace(model_, facts_, causers());
  return *push_exclusion_;
}

const std::vector<Imprecise>& Shared::imprecise() const {
  if (!imprecise_) imprecise_ = find_imprecise(model_, causers(), facts_, chains());
  return *imprecise_;
}

const std::vector<Wanting>& Shared::wants() const {
  if (!wants_) wants_ = find_wants(model_, facts_, chains(), causers());
  return *wants_;
}

const std::vector<Wanting>& Shared::wants_of_pushed() const {
  if (!wants_of_pushed_)
    wants_of_pushed_ = find_wants_of_pushed(model_, facts_, chains(), causers(), indispensable(), wants());
  return *wants_of_pushed_;
}

std::vector<const Want*> Shared::wants_of(GroupId task) const {
  const std::vector<Wanting>& all = wants();
  std::vector<const Want*> out;
  auto at = std::lower_bound(all.begin(), all.end(), task,
                             [](const Wanting& wanting, GroupId group) { return wanting.task < group; });
  for (; at != all.end() && at->task == task; ++at) {
    for (const Want& want : at->wants) out.push_back(&want);
  }
  return out;
}

const Indispensable& Shared::indispensable() const {
  if (!indispensable_) indispensable_.emplace(model_);
  return *indispensable_;
}

const Rivals& Shared::rivals() const {
  if (!rivals_) rivals_.emplace(model_, facts_.holding, facts_.active);
  return *rivals_;
}

Units& Shared::units() const {
  if (!units_) units_.emplace(model_, facts_, budget_);
  return *units_;
}

Standstill& Shared::standstill() const {
  if (!standstill_) standstill_.emplace(model_, facts_, requests(), causers(), budget_);
  return *standstill_;
}

const Branches& Shared::branches() const {
  if (!branches_)
    branches_.emplace(model_,
                      Branches::Counted{[this](ProviderId id) { return is_active(id); },
                                        [this](ProviderId id) {
                                          const std::vector<EdgeId>& requesters =
                                              model_.groups[model_.providers[id].group].requesters;
                                          return facts_.capable.contains(id) &&
                                                 std::any_of(requesters.begin(), requesters.end(),
                                                             [this](EdgeId edge) { return model_.edges[edge].needed; });
                                        },
                                        {}});
  return *branches_;
}

const Claims& Shared::claims(GroupId task) const {
  if (!claims_) claims_.emplace(branches());
  return claims_->of(task);
}

const Claims& Shared::claims(GroupId task, GroupId requester) const {
  // If nothing leads back to the requester, the two are equal.
  const Claims& all = claims(task);
  if (!all.contains(requester)) return all;
  const std::pair key{task, requester};
  const auto at = claims_without_.find(key);
  if (at != claims_without_.end()) return at->second;
  return claims_without_.try_emplace(key, branches(), task, std::vector<GroupId>{requester}).first->second;
}

} // namespace director::analysis
