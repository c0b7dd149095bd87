#pragma once
// SPDX-License-Identifier: MIT
// Which causing providers may be pushed, given what is known to be possible so far (semantics.md 4.4, "Refuse").

#include "compiler/analysis/chains/meetings.hpp"
#include "compiler/analysis/chains/sparse_set.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/facts/waiting.hpp"

#include <optional>

namespace director::analysis {

/// For each condition the providers that cause it, in order.
using Causers = IdTable<ConditionId, std::vector<ProviderId>>;
Causers find_causers(const Model& model);

/// What every search for pushes asks again and again. Requests and values are those of `facts` when it is made.
class Pushes {
public:
  Pushes(const Model& model, const Facts& facts, const Chains& chains, const Causers& causers);

  /// The one may be lacking while the other is.
  bool may_lack_with(ConditionId id, ConditionId wanted) const;

  /// Each condition of the rival holds wherever those of the causer do, or can be served by whoever serves those; or
  /// because what is wanted is lacking.
  bool holds_with(ProviderId rival, ProviderId causer, ConditionId wanted) const;

  /// Never pushed for this: it waits for the same or more itself, so that whoever brings that about serves without it;
  /// or an earlier one of its group causes it too, and can be pushed whenever this one can.
  bool is_passed_over(ProviderId causer, ConditionId wanted) const;
  std::optional<ProviderId> earlier_causer(ProviderId causer, ConditionId wanted) const;

private:
  friend class PushSearch;
  bool may_hold(ConditionId id) const;
  bool is_mended(ProviderId provider, ConditionId id) const;
  void find_hopeful();

  const Model& model_;
  const Facts& facts_;
  const Chains& chains_;
  const Causers& causers_;
  Waiting waiting_;
  IdSet<ProviderId> hopeful_; ///< causing providers that could be pushed by one who goes before everybody
};

/// What searches have found that had this in common: a later one need not go there again.
struct Explored {
  IdSet<ProviderId> pushable;
  IdSet<ConditionId> conditions; ///< who causes them is pushable, and so on for what these wait for
  explicit Explored(const Model& model) : pushable(model.providers.size()), conditions(model.conditions.size()) {}
};

/// The causing providers that a task for one group may push. Looks only as far as it is asked: to follow every chain of
/// causes from each task that waits somewhere along it would take the square of its length.
class PushSearch {
public:
  /// `waiter` is a requested group.
  PushSearch(Pushes& all, GroupId waiter);

  /// It may go before the group of this causing provider.
  bool beats(GroupId group);
  /// It may hold, or a chain of pushes may bring it about.
  bool is_servable(ConditionId id);
  /// The task waits for this condition itself, and may push the provider for it.
  bool may_push(ProviderId causer, ConditionId condition);
  /// Those that may be pushed, by way of chains too, and are not in `explored` already.
  std::vector<ProviderId> explore(Explored& explored);

private:
  bool may_serve(ProviderId causer);
  bool serves(ProviderId causer);
  bool can_be_completed(ProviderId provider);
  void settle(ConditionId id);

  Pushes& all_;
  GroupId waiter_;
  std::vector<ProviderId> providers_;
  SparseSet<GroupId> beaten_, compared_;
  SparseSet<ConditionId> settled_, servable_;    ///< of those that do not hold anyway
  std::optional<SparseSet<ConditionId>> wanted_; ///< by the task itself, where it can be completed
};

/// In order of id.
std::vector<ProviderId> find_pushable(const Model& model, Pushes& all, GroupId waiter);

/// Who may push whom at all: requested groups, each with those that a task for it may push. In order.
std::vector<std::pair<GroupId, ProviderId>> find_all_pushes(const Model& model, const Facts& facts);

/// What a task for this group may wait for: the conditions of its providers and of those in their plans.
std::vector<std::pair<ProviderId, ConditionUse>> waited_conditions(const Model& model, const Facts& facts,
                                                                   GroupId waiter);

} // namespace director::analysis
