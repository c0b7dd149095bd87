#pragma once
// SPDX-License-Identifier: MIT
// Finds start and stop handlers that set a state against or for their own group.

#include "compiler/analysis/facts/facts.hpp"

#include <vector>

namespace director::analysis {

struct SelfDefeat {
  GroupId group{};
  bool stop = false; ///< the stop lets the group run again; else the start prevents it
  ProviderId provider{};
  ConditionUse entry{};     ///< in the handler's `sets`
  ConditionUse condition{}; ///< in the provider's `when`, on the same state
};

/// Only for requested groups; the first provider that an entry defeats, in order of group.
std::vector<SelfDefeat> find_self_defeats(const Model& model, const Facts& facts);

} // namespace director::analysis
