#pragma once
// SPDX-License-Identifier: MIT
// Finds the causing providers that may be pushed, given what is known to be possible so far (semantics.md 4.4,
// "Refuse").

#include "compiler/analysis/chains/meetings.hpp"
#include "compiler/analysis/chains/sparse_set.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/facts/push_exclusion.hpp"
#include "compiler/analysis/facts/waiting.hpp"
#include "compiler/model/causers.hpp"

#include <optional>

namespace director::analysis {

/// What all searches for pushes share. Requests and values are those of `facts` at construction.
class Pushes {
public:
  Pushes(const Model& model, const Facts& facts, const Chains& chains, const Causers& causers);

  /// Whether the one may be false while the other is.
  bool may_lack_with(ConditionId id, ConditionId wanted) const;

  /// Whether each condition of the rival holds wherever those of the causer do, or is served together with those, or
  /// holds because the wanted condition is false.
  bool holds_with(ProviderId rival, ProviderId causer, ConditionId wanted) const;

  /// Whether it is never pushed for this condition: it waits for the same or more itself, so that what causes that
  /// serves without it; or an earlier provider of its group causes the condition too, and can be pushed whenever this
  /// one can.
  bool is_passed_over(ProviderId causer, ConditionId wanted) const;
  std::optional<ProviderId> earlier_causer(ProviderId causer, ConditionId wanted) const;

  const PushExclusion& exclusion() const { return exclusion_; }

private:
  friend class PushSearch;
  bool may_hold(ConditionId id) const;
  bool is_corrected(ProviderId provider, ConditionId id) const;
  bool excludes_some_causer(ProviderId waiter, ConditionId id) const;
  void find_hopeful();

  const Model& model_;
  const Facts& facts_;
  const Chains& chains_;
  const Causers& causers_;
  Waiting waiting_;
  PushExclusion exclusion_;
  IdSet<ProviderId> could_be_pushed_; ///< causing providers that a task before all others could push
};

/// Shared results of searches, so that a later one need not repeat them.
struct Explored {
  IdSet<ProviderId> pushable;
  IdSet<ConditionId> conditions; ///< whose causers are pushable, and so on for what these wait for
  explicit Explored(const Model& model) : pushable(model.providers.size()), conditions(model.conditions.size()) {}
};

/// The causing providers that a task for one group may push. Searches only what is queried: following every chain of
/// causes from each task that waits along it would be quadratic in its length.
class PushSearch {
public:
  /// `waiter` is a requested group.
  PushSearch(Pushes& all, GroupId waiter);

  /// Whether it may go before the group of this causing provider.
  bool beats(GroupId group);
  /// Whether it may hold, or a chain of pushes may cause it.
  bool is_servable(ConditionId id);
  /// Whether the task waits for this condition itself, and may push the provider for it.
  bool may_push(ProviderId causer, ConditionId condition);
  /// Whether it may push the causer for this condition of another provider, which it pushes too.
  bool may_push_for(ProviderId pushed, ProviderId causer, ConditionId condition);
  /// Those that may be pushed, also through chains, and are not in `explored` already.
  std::vector<ProviderId> explore(Explored& explored);

private:
  bool may_serve(ProviderId causer);
  bool serves(ProviderId causer);
  bool is_servable_for(ProviderId provider, ConditionId id);
  bool can_be_completed(ProviderId provider);
  void settle(ConditionId id);

  Pushes& all_;
  GroupId waiter_;
  std::vector<ProviderId> providers_;
  SparseSet<GroupId> beaten_, compared_;
  SparseSet<ConditionId> settled_, servable_;    ///< of those that do not hold anyway
  std::optional<SparseSet<ConditionId>> wanted_; ///< by the task itself, if it can be completed
  std::vector<ProviderId> wanting_;              ///< ... of its providers
};

/// In order of id.
std::vector<ProviderId> find_pushable(const Model& model, Pushes& all, GroupId waiter);

/// All possible pushes: requested groups, each with the providers that a task for it may push. In order.
std::vector<std::pair<GroupId, ProviderId>> find_all_pushes(const Model& model, const Facts& facts);

/// What a task for this group may wait for: the conditions of its providers and of those in their plans.
std::vector<std::pair<ProviderId, ConditionUse>> waited_conditions(const Model& model, const Facts& facts,
                                                                   GroupId waiter);

} // namespace director::analysis
