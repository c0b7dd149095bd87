#pragma once
// SPDX-License-Identifier: MIT
// What may ever happen in a deployment: the least fixed point of rules like "a provider may be active if its group may
// be requested and its conditions may hold there". It takes every state for itself and forgets order, so it errs on one
// side only: what is not among the facts never happens, what is among them may. Method: checks.md, "When and Causing"
// (Dowling and Gallier 1984).

#include "compiler/analysis/effort/budget.hpp"
#include "compiler/analysis/plans/plans.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/graph/graph.hpp"
#include "compiler/model/model.hpp"

#include <span>
#include <vector>

namespace director::analysis {

using namespace director::compiler;

/// Conditions of one provider on one state that nothing can satisfy, by declarations alone. The rule that reports it is
/// reason enough: everywhere else they are taken for mended.
struct Impossible {
  enum class Why {
    contradictory,  ///< no value satisfies all of them
    without_source, ///< the state never has a value
    unreachable     ///< what sets the state never sets it to such a value
  };
  ProviderId provider{};
  bool stay = false; ///< of `stay`; else of `when`
  StateId state{};
  Why why = Why::contradictory;
  std::vector<ConditionUse> uses; ///< in the order written
};

struct Facts {
  IdTable<StateId, ValueSet> declared; ///< what any source names, whether or not it can ever act
  std::vector<Impossible> impossible;  ///< in order of provider
  IdTable<ProviderId, PlanVerdict> plans;
  IdSet<GroupId> may_wait; ///< some provider of it, or of a group that its plans may hold, has a `when`

  IdTable<StateId, ValueSet> values; ///< that the state may have
  IdTable<StateId, ValueSet> given;  ///< ... and that something may give it again; not those of the start alone
  IdSet<GroupId> capable_groups;     ///< some provider is capable
  IdSet<GroupId> requested;
  IdSet<EdgeId> holding;             ///< by which something alive may hold their target: requested, or in some plan
  IdTable<GroupId, Region> contexts; ///< of requested groups: around all states in which a task for it is tried
  IdTable<GroupId, Region> grants;   ///< ... in which it can be granted, with all that is granted together with it
  IdSet<ProviderId> capable;         ///< its conditions may hold, together with those of some choice for its needs
  IdSet<ProviderId> excluded; ///< capable, its group requested, but only where its conditions, or its needs', fail
  IdSet<ProviderId> chosen;   ///< capable, and sometimes the first that is, or it was not decided
  std::vector<EdgeId>
      excluded_tasks;       ///< of groups that run for others: so is every provider where this one asks for it
  IdSet<ProviderId> pushed; ///< somebody may push it
  IdSet<ProviderId> active; ///< its group requested, and it is chosen or pushed and capable

  Budget budget; ///< what the search for all this has left to the checks

  std::span<const Impossible> impossible_of(ProviderId provider) const;
  /// Of this provider's `when`, the conditions on this state are reported as impossible.
  bool is_impossible(ProviderId provider, StateId state) const;
  /// It may hold. True also for what is reported as impossible.
  bool may_hold(const Model& model, ProviderId provider, const ConditionUse& condition) const;
  /// It holds wherever all states are in the region.
  bool holds_always(const Model& model, ConditionId condition, const Region& region) const;
};

/// What is reported as impossible by declarations alone (`impossible`, needs without a plan).
enum class Reported {
  mended, ///< is taken for mended: what would never happen for want of it is no finding of its own
  as_is   ///< never happens, and nothing that takes it either
};

Facts find_facts(const Model& model, const Graph& graph, Reported reported = Reported::mended);

} // namespace director::analysis
