#pragma once
// SPDX-License-Identifier: MIT
// Finds conditions that no push can cause while they are false, because all that could cause them waits for them,
// itself or in a cycle (semantics.md 4.4, "Refuse": no provider is above itself).

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/model/causers.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace director::analysis {

class CausingCycles {
public:
  /// All must outlive this.
  CausingCycles(const Model& model, const Facts& facts, const Causers& causers);

  /// Whether this provider runs only while the condition holds already, by what it and its needs without alternative
  /// require.
  bool waits_for(ProviderId causer, ConditionId condition) const;

  /// Around the states with which a chain of pushes for the condition can begin with one of its causers, if each of
  /// them waits for what only others of the cycle could cause; `counts`: the causers that are considered. Nothing:
  /// another one can be pushed, or there is none.
  std::optional<std::vector<Region>> beginnings(ConditionId condition,
                                                const std::function<bool(ProviderId)>& counts) const;

private:
  /// Around the states with which it runs, its needs without alternative included.
  Region around(ProviderId causer) const;
  bool comes_otherwise(ProviderId waiter, const ConditionUse& use) const;

  const Model& model_;
  const Facts& facts_;
  const Causers& causers_;
  IdSet<ConditionId> given_; ///< something other than a promise or the outside makes it true
  IdSet<ProviderId> free_;   ///< can be pushed whatever the others of a cycle wait for
};

} // namespace director::analysis
