#pragma once
// SPDX-License-Identifier: MIT
// Whether the conditions of two providers keep the one from ever pushing the other (semantics.md 4.4, "Refuse"): a push
// is made only while every condition of both holds that no provider can cause.

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/model/causers.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace director::analysis {

class PushExclusion {
public:
  /// All must outlive this; of `facts` only what is reported as impossible counts.
  PushExclusion(const Model& model, const Facts& facts, const Causers& causers);

  /// A state that would have to have different values for the waiting provider to push the other one, by conditions of
  /// both and of what they need without alternative.
  std::optional<StateId> find(ProviderId waiter, ProviderId causer) const;
  bool excludes(ProviderId waiter, ProviderId causer) const { return find(waiter, causer).has_value(); }
  /// The same, of the states that only the outside changes: while the one waits, the other cannot run by itself either.
  std::optional<StateId> find_outside(ProviderId waiter, ProviderId causer) const;
  /// The same while tasks for them exist only with these values.
  std::optional<StateId> find_outside(ProviderId waiter, const Region& waiting, ProviderId causer,
                                      const Region& requested) const;
  /// The same for a provider that need not wait itself, as one of its needs does.
  std::optional<StateId> find_beside(ProviderId chosen, ProviderId causer) const;

  /// Those conditions on the state, each with its provider: of this one and of what it needs.
  std::vector<std::pair<ProviderId, ConditionUse>> conditions_on(StateId state, ProviderId provider) const;
  /// The values that they leave of those in the region.
  ValueSet values_of(StateId state, ProviderId provider, const Region& region = {}) const;
  /// The providers of the groups that it needs, directly or not, and that have no other provider.
  std::vector<ProviderId> needed(ProviderId id) const;

private:
  /// Around the states with which the provider waits for a push, or can be chosen; what it needs included.
  const Region& region(ProviderId id, bool waits) const;
  Region own(ProviderId id, bool waits) const;

  const Model& model_;
  const Facts& facts_;
  const Causers& causers_;
  IdSet<StateId> outside_;
  mutable IdTable<ProviderId, std::optional<Region>> waiting_, chosen_;
};

} // namespace director::analysis
