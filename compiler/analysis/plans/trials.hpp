#pragma once
// SPDX-License-Identifier: MIT
// How many combinations of providers and plans the engine may have to try (semantics.md 4.4, as
// runtime/core/arbitration/combination.cpp does it). Members of a unit that can never claim the same group are chosen
// one by one, and add up; those that can are combined, and multiply.

#include "compiler/analysis/plans/plans.hpp"

#include <vector>

namespace director::analysis {

/// At some level the task is granted with the other mandatory ones of its pack, whole or not at all.
bool may_be_member(const Model& model, const Task& task);

/// What one decision is about: a task alone, or the tasks of a pack that are granted together.
struct CountedUnit {
  std::vector<const Task*> members;
  /// The members by cluster: who can claim the same group as others, or is alone. In order.
  std::vector<std::vector<const Task*>> colliding;
};

struct TrialCount {
  std::int64_t count = 0;
  bool complete = true; ///< false: at least so many
};

/// What a group asks for at a time is one pack, or list, of one of its providers: the one that one pass tries most for.
struct LargestPack {
  TrialCount count;      ///< 0: the group asks for nothing
  ProviderId provider{}; ///< whose it is
};

class Trials {
public:
  /// `most_plans`: of one provider, more are not counted.
  Trials(const Model& model, std::int64_t most_plans, Budget& budget);

  CountedUnit alone(const Task& task) const;
  CountedUnit together(const Pack& pack) const; ///< without members: everything in it is decided alone

  /// To have the group: its providers, each with each plan of its needs.
  const TrialCount& ways(GroupId group);
  PlanCount plans(ProviderId provider);
  /// All combinations of members that can claim the same group.
  TrialCount product(const std::vector<const Task*>& members);
  /// The largest of these products: what the members multiply to.
  TrialCount ways(const CountedUnit& unit);
  /// What one decision about the unit tries at most.
  TrialCount decision(const CountedUnit& unit);
  /// What one pass tries for the tasks of a pack: the unit whole, and each task alone, where it is none of the unit,
  /// below a stale group, or where others wait; each with its conditions, and then without, for what it lacks.
  TrialCount pass(const Pack& pack);
  TrialCount pass(const Task& root);
  LargestPack pass(GroupId group);

private:
  const Model& model_;
  std::int64_t most_plans_;
  Budget& budget_;
  IdTable<EdgeId, EdgeId> clusters_;
  IdTable<GroupId, std::optional<TrialCount>> ways_;
};

} // namespace director::analysis
