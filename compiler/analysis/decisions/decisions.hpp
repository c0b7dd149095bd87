#pragma once
// SPDX-License-Identifier: MIT
// Finds what may follow from every decision: an abstract interpretation of a whole component, for what facts.hpp
// ignores: the order of events, which values states have together, and what is held then.
//
// Domain. A Moment: the holder of each group, its active provider, what is requested at which level, and the kinds of
// the values of states. It leaves out the order of requests, the queue of runs, done flags, timers, and the pushes in
// force: only which pushes may ever be in force is kept, for all moments together (PossiblePush). The order is
// inclusion of sets of moments.
//
// Steps. From a moment: any inputs at rest, or several before a run; any answer of the body of any granted group; what
// handlers set. Then the pass of semantics.md, 4.4, with every outcome that the omitted information allows. So each
// moment of each real run has its image among those that are found: what is not found never happens. A known order, as
// by priorities, decides; among equals each one may be first.
//
// Shared work. Ways through one pass that reach the same point are followed once from there (Pass::Way), since most
// orders of equals lead to the same; and a repeated request counts only if it changes something for some group.
//
// Fixed point. All moments from the start, again after each new push, of which there are finitely many. A bound on
// steps ends it: beyond it nothing is reported. It also ends as soon as everything has been found that the facts allow,
// since then there is nothing to report: most behaviours end so after some hundred passes.
//
// Cost: a pass takes two to four microseconds; the number of moments grows with the product of what groups may do, so
// only components of few groups are examined (Component::most_groups), and all of them together take at most
// `most_steps`. Steps are counted within a pass, so that parts with many edges or plans take no longer than others.
#include "compiler/analysis/decisions/component.hpp"
#include "compiler/analysis/effort/budget.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace director::analysis {

/// What prevented a grant, in all decisions about it together.
struct Hindrance {
  std::vector<ConditionId> lacking;
  std::vector<GroupId> taken;
  std::vector<EdgeId> holders;   ///< the edges that held those
  std::vector<ProviderId> first; ///< of a provider: others of its group that came before it
  std::vector<EdgeId> together;  ///< of a task: others without which it is not granted
};

struct Decisions {
  IdSet<GroupId> looked_at; ///< others are in parts that are too large, or take too many steps
  IdSet<GroupId> decided;   ///< groups for which the result is complete; nothing is reported for others
  IdSet<ProviderId> runs;
  IdSet<EdgeId> requested, granted;
  std::set<std::pair<ProviderId, std::size_t>> whole; ///< packs whose members, two or more, are granted together
  std::set<std::pair<ProviderId, ConditionId>> pushed;
  IdTable<ProviderId, Hindrance> passed_over;
  IdTable<EdgeId, Hindrance> refused;
  /// In some decision it was chosen, but before its run a handler, or the stop of their group, set these states.
  IdTable<ProviderId, std::vector<StateId>> set_before_run;
  std::size_t moments = 0, passes = 0; ///< that were examined

  /// For all parts together: a third of a second. Measured on six dense behaviours of four to eight groups that use all
  /// of them: 0.30 to 0.43 s, 33 to 47 ns a step. A pass over five groups takes some fifty, over ten some hundreds.
  static constexpr std::int64_t most_steps = 9'000'000;
  /// For a file of so many groups. With more groups the limit decreases in proportion, down to an eighteenth: in a very
  /// large file this shall take at most a tenth of the time of the other checks.
  static constexpr std::int64_t many_groups = 100;
  static constexpr std::int64_t steps_for(std::size_t groups) {
    const auto all = static_cast<std::int64_t>(groups);
    return all <= many_groups ? most_steps : std::max(most_steps * many_groups / all, most_steps / 18);
  }

  bool never_runs(const Model& model, ProviderId id) const {
    return decided.contains(model.providers[id].group) && !runs.contains(id);
  }
  bool never_granted(const Model& model, EdgeId id) const {
    return decided.contains(model.edges[id].target) && !granted.contains(id);
  }
  bool never_pushed(const Model& model, ProviderId id, ConditionId condition) const {
    return decided.contains(model.providers[id].group) && pushed.count({id, condition}) == 0;
  }
};

/// If a component was examined and not decided, everything in it happens that the facts allow.
Decisions find_decisions(const Model& model, const Facts& facts, Reported reported, Budget& budget);

} // namespace director::analysis
