#pragma once
// SPDX-License-Identifier: MIT
// Finds steps of a group that wait for a push, though the group's own state begins again while it waits: it is not
// granted meanwhile.

#include "compiler/analysis/input.hpp"

#include <vector>

namespace director::analysis {

struct LostStep {
  ProviderId waiter{};
  ConditionUse step{};      ///< on the group's own state
  ConditionUse condition{}; ///< that it waits for
  ProviderId causer{};      ///< could be pushed for that
};

std::vector<LostStep> find_lost_steps(const Input& input);

} // namespace director::analysis
