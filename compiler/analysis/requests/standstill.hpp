#pragma once
// SPDX-License-Identifier: MIT
// Decides whether a requested task may have to wait for one condition.

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

  /// Whether, while this request exists, there are states with which no provider of its group can run, this condition
  /// is false, and `waiter` might push for it: what the waiter lacks besides does not depend only on inputs. `absent`:
  /// groups that do not run.
  bool may_wait(const Request& request, ProviderId waiter, const ConditionUse& use,
                const std::vector<GroupId>& absent = {});
  /// The same with values in this region.
  bool may_wait(const Region& region, ProviderId waiter, const ConditionUse& use, const std::vector<GroupId>& absent);

private:
  /// Whether what the waiter lacks besides could be caused too. Otherwise it pushes nothing.
  bool is_servable(ProviderId waiter, ConditionId id) const;

  const Model& model_;
  const Facts& facts_;
  const Requests& requests_;
  const Causers& causers_;
  Budget& budget_;
  Ways ways_;
};

} // namespace director::analysis
