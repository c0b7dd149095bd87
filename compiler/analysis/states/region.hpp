#pragma once
// SPDX-License-Identifier: MIT
// The values that a conjunction of conditions accepts, for each state in it. States are independent: whether two of
// them can have two values at the same time is ignored.

#include "compiler/model/model.hpp"

#include <map>
#include <vector>

namespace director::analysis {

using namespace director::compiler;

struct Region {
  std::map<StateId, ValueSet> states; ///< a state that is not here may have any value, or be unset

  bool empty() const; ///< nothing satisfies it
  void meet(StateId state, const ValueSet& values);
  void meet(const Region& other);
};

Region region_of(const Model& model, const std::vector<ConditionUse>& conditions);

/// The smallest region around both: a state that one of them does not restrict is not restricted.
Region hull(const Region& a, const Region& b);

/// Where a provider can be active: by its `when` or by its `stay`.
Region active_region(const Model& model, const Provider& provider);

/// Whether `outer` holds wherever `inner` does.
bool contains(const Region& outer, const Region& inner);

/// False: some state would need two values at once.
bool compatible(const Region& a, const Region& b);

} // namespace director::analysis
