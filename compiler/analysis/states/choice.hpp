#pragma once
// SPDX-License-Identifier: MIT
// When a provider is the first of its group that can run.

#include "compiler/analysis/states/covering.hpp"
#include "compiler/analysis/states/region_index.hpp"
#include "compiler/model/model.hpp"

#include <vector>

namespace director::analysis {

/// For each provider the earlier ones of its group that can run whenever their `when` holds and this one can run: what
/// they need nobody else can hold, or this one needs it itself.
class Rivals {
public:
  /// `claimable`: groups that something alive may hold; it may grow.
  Rivals(const Model& model, const IdSet<GroupId>& claimable);

  std::vector<ProviderId> of(ProviderId provider) const { return that_meet(provider, {}); }
  /// Those whose `when` may hold within the region. The others lack something there anyway.
  std::vector<ProviderId> that_meet(ProviderId provider, const Region& region) const;

private:
  bool is_needed(GroupId group) const;

  const Model& model_;
  const IdSet<GroupId>& claimable_;
  IdTable<ProviderId, std::size_t> place_; ///< among those of its group
  IdTable<GroupId, RegionIndex> regions_;  ///< of its providers, by `when`
};

/// Whether `others` cover all of `own`, each state having one of `values` or, where `own` does not speak of it and it
/// may, none. Open: `own` can hold while each of the others lacks something.
Covering find_covering(const Model& model, const Region& own, const std::vector<Region>& others,
                       const IdTable<StateId, ValueSet>& values, Budget& budget);

/// The same of the `when` of a provider and those of `rivals`. Covered: it never comes first.
Covering find_choice(const Model& model, ProviderId provider, const std::vector<ProviderId>& rivals,
                     const IdTable<StateId, ValueSet>& values, Budget& budget);

} // namespace director::analysis
