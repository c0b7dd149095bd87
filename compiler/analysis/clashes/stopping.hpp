#pragma once
// SPDX-License-Identifier: MIT
// Finds what cannot run while some conditions do not hold: providers that need one of them, and what only these
// request. Exact in what it reports: everything else is assumed possible.

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/states/sources.hpp"

#include <map>
#include <optional>
#include <set>
#include <vector>

namespace director::analysis {

/// A provider under examination counts as stopped: otherwise it would depend only on itself.
class Stopping {
public:
  Stopping(const Model& model, const Facts& facts, const IdTable<StateId, std::vector<Source>>& sources)
      : model_(model),
        facts_(facts),
        sources_(sources) {}

  /// Assumes that the condition does not hold; whether it may become true again is ignored.
  void suppose_lost(ConditionId id);
  /// Whether the condition, once lost, never becomes true again, as all its sources cannot run. If necessary, other
  /// conditions are lost with it, each on another state, for which that is true too.
  bool lose(ConditionId id);

  /// `lose_more`: other conditions may be lost for it, as above.
  bool cannot_run(ProviderId id, bool lose_more);
  bool cannot_run(GroupId group, bool lose_more);

  /// In the order of discovery.
  const std::vector<ConditionId>& lost() const { return order_; }
  /// Whether it was found that it cannot run.
  bool is_stopped(ProviderId id) const { return !facts_.active.contains(id) || stopped_.count(id) != 0; }
  /// The lost condition of its own for lack of which it cannot run.
  std::optional<ConditionUse> lacked_by(ProviderId id) const;

private:
  bool is_lost(ConditionId id) const;
  bool may_be_lacking(ConditionId id) const;
  bool lose_too(ConditionId id);
  bool cannot_act(const Source& source);
  bool is_always_needed(ProviderId id, const ConditionUse& use) const;
  bool is_unrequested(GroupId group, bool lose_more);
  template <class Takes>
  bool lacks(ProviderId id, const Takes& takes);
  template <class Attempt>
  bool tries(const Attempt& attempt);

  const Model& model_;
  const Facts& facts_;
  const IdTable<StateId, std::vector<Source>>& sources_;
  std::map<StateId, ConditionId> lost_;
  std::vector<ConditionId> order_;
  std::set<ProviderId> stopped_; ///< including those under examination
  std::size_t steps_ = 0;
};

} // namespace director::analysis
