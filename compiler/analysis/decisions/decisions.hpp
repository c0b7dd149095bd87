#pragma once
// SPDX-License-Identifier: MIT
// What may come of every decision: an abstract interpretation of a whole component, for what facts.hpp forgets: the
// order of events, which values states have together, and who holds what then.
//
// Domain. A Moment: who holds each group and for whom, which provider runs, what is requested at which level, and the
// kinds of the values of states. It leaves out in what order requests were made, the queue of runs, done flags, timers,
// and the pushes that stand: of these only which ones may ever stand is kept, for all moments together (PossiblePush).
// The order is inclusion of sets of moments.
//
// Steps. From a moment whatever inputs may come at rest, or several before a run; whatever the body of any group that
// is granted may answer; what handlers set. Then the pass of semantics.md, 4.4, with every outcome that what is left
// out could lead to. So each moment of each real run has its image among those that are found: what is not found never
// happens. Where an order is known, as by priorities, it decides; among equals each one may be first.
//
// What need not be done twice. Ways through one pass that come together are followed once from there (Pass::Way), since
// most orders of equals lead to the same; and a request that is made anew counts only where it is news to somebody.
//
// Fixed point. All moments from the start, again while new pushes turn up, which can only be finitely many. A bound on
// steps ends it: beyond it nothing is said. It also ends as soon as all that the facts take for possible was found,
// since then there is nothing to say: most behaviours end so after some hundred passes.
//
// Cost: a pass takes two to four microseconds; moments grow with the product of what groups may do, so only components
// of few groups are looked at (Component::most_groups), and all of them together take no more than `most_steps`. Steps
// are counted within a pass, so that parts of many edges or plans take no longer than others.
#include "compiler/analysis/decisions/component.hpp"
#include "compiler/analysis/effort/budget.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace director::analysis {

/// What kept something from being granted, in all decisions about it together.
struct Kept {
  std::vector<ConditionId> lacking;
  std::vector<GroupId> taken;
  std::vector<EdgeId> holders;   ///< for whom those were held
  std::vector<ProviderId> first; ///< of a provider: others of its group that came before it
  std::vector<EdgeId> together;  ///< of a task: others without which it is not granted
};

struct Decisions {
  IdSet<GroupId> looked_at; ///< others are of parts that are too large, or take too many steps
  IdSet<GroupId> decided;   ///< about which all is known that follows; of others nothing is said
  IdSet<ProviderId> runs;
  IdSet<EdgeId> requested, granted;
  std::set<std::pair<ProviderId, std::size_t>> whole; ///< packs whose members, two or more, are granted together
  std::set<std::pair<ProviderId, ConditionId>> pushed;
  IdTable<ProviderId, Kept> passed_over;
  IdTable<EdgeId, Kept> refused;
  std::size_t moments = 0, passes = 0; ///< that were looked at

  /// Of all parts together: a third of a second. Measured on six dense behaviours of four to eight groups that take all
  /// of them: 0.30 to 0.43 s, 33 to 47 ns a step. A pass over five groups takes some fifty, over ten some hundreds.
  static constexpr std::int64_t most_steps = 9'000'000;
  /// Of a file of so many groups. With more of them than that the steps become fewer, as many fewer as there are more
  /// groups, down to an eighteenth: in a file of very many it shall take no more than a tenth of what the other checks
  /// do.
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

/// Where a component was looked at, and not all was decided, all happens that the facts take for possible.
Decisions find_decisions(const Model& model, const Facts& facts, Reported reported, Budget& budget);

} // namespace director::analysis
