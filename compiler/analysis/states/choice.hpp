#pragma once
// SPDX-License-Identifier: MIT
// Decides when a provider is the first of its group that can run.

#include "compiler/analysis/states/covering.hpp"
#include "compiler/analysis/states/region_index.hpp"
#include "compiler/graph/dominators.hpp"
#include "compiler/model/model.hpp"

#include <functional>
#include <set>
#include <vector>

namespace director::analysis {

/// An earlier provider of the group, and regions in each of which it can run whenever the later one can: no other group
/// can hold its needs, or the later one needs them itself.
struct Rival {
  ProviderId provider{};
  std::vector<Region> ways;
};

class Rivals {
public:
  /// `holding`: edges through which a group that may run may hold their target; it may grow, like `active`.
  Rivals(const Model& model, const IdSet<EdgeId>& holding, const IdSet<ProviderId>& active);

  /// In the order of preference, at most up to the first one that can run whenever the later one can: none after it
  /// matters.
  std::vector<Rival> of(ProviderId provider) const {
    return that_meet(provider, {}, [](const Rival&) { return true; });
  }
  /// Those whose `when` may hold within the region. The others lack something there anyway. `counts`: whether a rival
  /// may be the last one.
  std::vector<Rival> that_meet(ProviderId provider, const Region& region,
                               const std::function<bool(const Rival&)>& counts) const;

private:
  /// Of one rival.
  struct Comparison {
    ProviderId provider{};     ///< the later one
    std::vector<GroupId> path; ///< the groups above, to detect cycles
    std::set<GroupId> parties; ///< all that the rival's plans may hold
  };
  std::vector<Region> ways(ProviderId rival, Comparison& comparison) const;
  std::vector<Region> ways(GroupId group, GroupId needer, Comparison& comparison) const;
  bool is_contended(GroupId group, GroupId needer, const Comparison& comparison) const;
  bool goes_without(GroupId holder, GroupId group, ProviderId provider) const;

  const Model& model_;
  const IdSet<EdgeId>& holding_;
  const IdSet<ProviderId>& active_;
  IdTable<ProviderId, std::size_t> place_; ///< among those of its group
  /// How many providers of the group there are up to the first one that can always run: later ones never matter.
  IdTable<GroupId, std::size_t> deciding_;
  IdTable<GroupId, RegionIndex> regions_; ///< of its providers, by `when`
  DominatorTree below_;                   ///< of groups below the roots, over requests and needs
};

/// Whether `others` cover all of `own`, if each state has one of `values` or, if it is not in `own` and may be, is
/// unset. Open: `own` can hold while each of the others lacks something.
Covering find_covering(const Model& model, const Region& own, const std::vector<Region>& others,
                       const IdTable<StateId, ValueSet>& values, Budget& budget);

/// The same for the ways of `rivals`. Covered: what is `own` never comes first.
Covering find_choice(const Model& model, const Region& own, const std::vector<Rival>& rivals,
                     const IdTable<StateId, ValueSet>& values, Budget& budget);

} // namespace director::analysis
