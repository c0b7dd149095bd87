#pragma once
// SPDX-License-Identifier: MIT
// Restricts what may happen to a part in which a group or provider is likely to run soon. An under-approximation: what
// happens there can happen, and what does not happen there proves nothing.

#include "compiler/explore/environment/ground.hpp"

#include <vector>

namespace director::compiler {

struct Goal {
  std::vector<GroupId> groups;
  std::vector<ProviderId> providers;
};

/// Leaves in `ground` what a plan for the goal needs: requested root tasks, set states, and answers of its bodies.
/// Other bodies give their usual answers. Nothing expires, breaks, waits or fires.
void focus_on(Ground& ground, const Goal& goal);

} // namespace director::compiler
