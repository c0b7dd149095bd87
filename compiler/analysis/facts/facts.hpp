#pragma once
// SPDX-License-Identifier: MIT
// Derives what may ever happen in a deployment: the least fixed point of rules like "a provider may be active if its
// group may be requested and its conditions may hold there". It treats every state independently and ignores order, so
// it is an over-approximation: what is not among the facts never happens, what is among them may. Method: unit
// propagation on Horn clauses (Dowling and Gallier 1984).

#include "compiler/analysis/effort/budget.hpp"
#include "compiler/analysis/plans/plans.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/graph/graph.hpp"
#include "compiler/model/model.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace director::analysis {

using namespace director::compiler;

/// Conditions of one provider on one state that nothing can satisfy, by declarations alone. The check that reports this
/// is enough: everywhere else they are treated as corrected.
struct Impossible {
  enum class Why {
    contradictory,  ///< no value satisfies all of them
    without_source, ///< the state never has a value
    unreachable     ///< no source sets the state to such a value
  };
  ProviderId provider{};
  bool stay = false; ///< of `stay`; else of `when`
  StateId state{};
  Why why = Why::contradictory;
  std::vector<ConditionUse> uses; ///< in the order of declaration
};

struct Facts {
  IdTable<StateId, ValueSet> declared; ///< what all sources name, whether or not they can ever act
  std::vector<Impossible> impossible;  ///< in order of provider
  IdTable<ProviderId, PlanVerdict> plans;
  IdSet<GroupId> may_wait; ///< some provider of it, or of a group that its plans may hold, has a `when`

  IdTable<StateId, ValueSet> values; ///< that the state may have
  IdTable<StateId, ValueSet> given;  ///< ... and that something may set again, besides the start
  IdSet<GroupId> capable_groups;     ///< some provider is capable
  IdSet<GroupId> requested;
  IdSet<EdgeId> holding;             ///< through which a group that may run may hold their target: requested, or in
                                     ///< some plan
  IdTable<GroupId, Region> contexts; ///< of requested groups: around all states in which a task for it is tried
  IdTable<GroupId, Region> grants;   ///< ... in which it can be granted, with all that is granted together with it
  IdSet<ProviderId> capable;         ///< its conditions may hold, together with those of some choice for its needs
  IdSet<ProviderId> excluded; ///< capable, its group requested, but only where its conditions, or its needs', fail
  IdSet<ProviderId> chosen;   ///< capable, and sometimes the first that is, or that was undecided
  std::vector<EdgeId> excluded_tasks; ///< in order; of groups that run for others: all providers are excluded where
                                      ///< this edge requests them
  IdSet<ProviderId> pushed;           ///< some task may push it
  IdSet<ProviderId> active;           ///< its group requested, and it is chosen or pushed and capable

  Budget budget; ///< what the search for all this has left to the checks

  std::span<const Impossible> impossible_of(ProviderId provider) const;
  /// Around the states with which it can begin: its `when`, without what is reported as impossible.
  Region region_to_begin(const Model& model, ProviderId provider) const;
  /// Around the states with which it can run: by its `when` or its `stay`, without what is reported as impossible, and
  /// if it is `pushed`, without what it causes itself.
  Region region_to_run(const Model& model, ProviderId provider, bool pushed) const;
  /// Whether conditions exclude its task for its requester, though it runs for others: uncovered_state reports that,
  /// and no other finding does, as nothing else would help.
  bool excludes(EdgeId edge) const { return std::binary_search(excluded_tasks.begin(), excluded_tasks.end(), edge); }
  /// Whether this provider's `when` conditions on this state are reported as impossible.
  bool is_impossible(ProviderId provider, StateId state) const;
  /// True also for what is reported as impossible.
  bool may_hold(const Model& model, ProviderId provider, const ConditionUse& condition) const;
  /// Whether it holds wherever all states are in the region.
  bool holds_always(const Model& model, ConditionId condition, const Region& region) const;
};

/// How to treat what is reported as impossible by declarations alone (`impossible`, needs without a plan).
enum class Reported {
  corrected, ///< treated as corrected: what never happens because of it is no further finding
  as_is      ///< as it is: it never happens, nor anything that depends on it
};

/// Which providers may run, as far as the program decides it.
enum class Enabled {
  all, ///< as at the start
  some ///< those that the program has not disabled: whatever is preferred to a provider, it may be the first that can
       ///< run
};

Facts find_facts(const Model& model, const Graph& graph, Reported reported = Reported::corrected,
                 Enabled enabled = Enabled::all);

} // namespace director::analysis
