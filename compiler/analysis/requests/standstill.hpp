#pragma once
// SPDX-License-Identifier: MIT
// Whether a task that is requested somewhere may have to wait for one condition.

#include "compiler/analysis/facts/pushes.hpp"
#include "compiler/analysis/requests/requests.hpp"

#include <vector>

namespace director::analysis {

class Standstill {
public:
  Standstill(const Model& model, const Facts& facts, const Requests& requests, const Causers& causers, Budget& budget)
      : model_(model),
        facts_(facts),
        requests_(requests),
        causers_(causers),
        budget_(budget),
        ways_(model, facts, false, [](ProviderId, const ConditionUse&) { return true; }) {}

  /// While this request stands, there are states under which no provider of its group can run, this condition being
  /// false, and `waiter` might push for it: what the waiter lacks besides is not up to the outside alone. `absent`: a
  /// state of one of these groups has its initial value.
  bool may_wait(const Request& request, ProviderId waiter, const ConditionUse& use,
                const std::vector<GroupId>& absent = {});

private:
  /// What the waiter lacks besides could be caused too. Else it pushes nobody.
  bool is_servable(ProviderId waiter, ConditionId id) const;
  Possible& possible(StateId state, Box& box) const;

  const Model& model_;
  const Facts& facts_;
  const Requests& requests_;
  const Causers& causers_;
  Budget& budget_;
  Ways ways_;
};

} // namespace director::analysis
