#pragma once
// When a provider is the first of its group that can run.

#include "compiler/checks/analysis/states/region_index.hpp"
#include "compiler/graph/graph.hpp"

#include <vector>

namespace director::checks {

/// For each provider the earlier ones of its group that can run whenever their `when` holds and this one can run: what
/// they need nobody else can hold, or this one needs it itself.
class Rivals {
public:
  Rivals(const Model& model, const Graph& graph);

  std::vector<ProviderId> of(ProviderId provider) const { return that_meet(provider, {}); }
  /// Those whose `when` may hold within the region. The others lack something there anyway.
  std::vector<ProviderId> that_meet(ProviderId provider, const Region& region) const;

private:
  const Model& model_;
  IdSet<GroupId> claimable_;
  IdSet<GroupId> needed_;
  IdTable<ProviderId, std::size_t> place_; ///< among those of its group
  IdTable<GroupId, RegionIndex> regions_;  ///< of its providers, by `when`
};

/// `own` can hold while each of `others` lacks something, each state having one of `values` or, where it may, none.
/// True also where that takes too long to find out.
bool may_escape(const Model& model, const Region& own, const std::vector<Region>& others,
                const IdTable<StateId, ValueSet>& values);

/// Its `when` can hold while each of `rivals` lacks something, each state having one of `values` or, where it may,
/// none. `open`: states that are no obstacle to it. True also where that takes too long to find out.
bool may_come_first(const Model& model, ProviderId provider, const std::vector<ProviderId>& rivals,
                    const IdTable<StateId, ValueSet>& values, const std::vector<StateId>& open);

} // namespace director::checks
