#pragma once
// SPDX-License-Identifier: MIT
// Finds conditions that only one provider causes, which runs once, as a root that goes before what waits for them: no
// task pushes it.

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/states/sources.hpp"

#include <map>
#include <optional>
#include <vector>

namespace director::analysis {

struct RootCauser {
  ProviderId causer{};
  const Task* root = nullptr; ///< of its group
};

class RootCausers {
public:
  RootCausers(const Model& model, const Facts& facts) : model_(model), facts_(facts) {}

  /// Of this condition in the `when` of the waiter.
  std::optional<RootCauser> of(ProviderId waiter, ConditionId condition);

private:
  std::optional<ProviderId> find_only_causer(ConditionId id);
  bool runs_once(ProviderId id) const;
  const Task* root_before(GroupId first, GroupId second) const;

  const Model& model_;
  const Facts& facts_;
  std::optional<IdTable<StateId, std::vector<Source>>> sources_;
  std::map<ConditionId, std::optional<ProviderId>> only_causers_;
};

} // namespace director::analysis
