#pragma once
// SPDX-License-Identifier: MIT
// Bounds how many combinations of providers and plans the engine may have to try (semantics.md 4.4, as implemented in
// runtime/core/arbitration/combination.cpp). Members of a unit that can never claim the same group are chosen one by
// one, and add up; those that can are combined, and multiply.

#include "compiler/analysis/plans/plans.hpp"

#include <cstdint>
#include <vector>

namespace director::analysis {

/// The unit of one decision: a task alone, or the tasks of a pack that are granted together.
struct CountedUnit {
  std::vector<const Task*> members;
  /// The members by cluster: those that can claim the same group, or one alone. In order.
  std::vector<std::vector<const Task*>> colliding;
};

struct TrialCount {
  std::int64_t count = 0;
  bool complete = true; ///< false: a lower bound
};

/// A group requests one pack, or list, of one of its providers at a time: the one for which a pass tries most.
struct LargestPack {
  TrialCount count;      ///< 0: the group requests nothing
  ProviderId provider{}; ///< the owner of the pack
};

/// What one pass over a component may try, by what requests it: roots, and groups in order, each by its largest pack.
struct PassTrials {
  struct Share {
    TrialCount count;
    const Task* root = nullptr; ///< null: the tasks of `provider`
    ProviderId provider{};
  };
  TrialCount sum;
  std::vector<Share> shares; ///< without those that request nothing
};

class Trials {
public:
  /// `most_plans`: limit for one provider; more are not counted.
  Trials(const Model& model, std::int64_t most_plans, Budget& budget);

  CountedUnit alone(const Task& task) const;
  CountedUnit together(const Pack& pack) const; ///< without members: everything in it is decided alone

  /// Ways to grant the group that may be tried: its providers, each with each plan of its needs, and each dead end.
  const TrialCount& ways(GroupId group);
  PlanCount plans(ProviderId provider);
  /// All combinations of members that can claim the same group.
  TrialCount product(const std::vector<const Task*>& members);
  /// The largest of these products: the multiplied ways of the members.
  TrialCount ways(const CountedUnit& unit);
  /// Bound for one decision about the unit.
  TrialCount decision(const CountedUnit& unit);
  /// Bound for the tasks of a pack in one pass: the unit whole, and each task alone, if it is in no unit, below a stale
  /// group, or others wait; each with its conditions, and then without, for what it lacks.
  TrialCount pass(const Pack& pack);
  TrialCount pass(const Task& root);
  LargestPack pass(GroupId group);
  /// For each component, by number: what `limits: {pass: ...}` limits, and the bound of `check --verbose`.
  std::vector<PassTrials> passes();
  std::uint32_t component(GroupId group) const { return components_[group]; }

private:
  const Model& model_;
  std::int64_t most_plans_;
  Budget& budget_;
  IdTable<EdgeId, EdgeId> clusters_;
  IdTable<GroupId, std::uint32_t> components_;
  IdTable<GroupId, std::optional<TrialCount>> ways_;
};

} // namespace director::analysis
