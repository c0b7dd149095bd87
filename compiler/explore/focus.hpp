#pragma once
// SPDX-License-Identifier: MIT
// A part of what may happen, in which a group or provider is likely to run soon. Less than everything: what happens
// there can happen, and what does not happen there tells nothing.

#include "compiler/explore/ground.hpp"

#include <vector>

namespace director::compiler {

struct Goal {
  std::vector<GroupId> groups;
  std::vector<ProviderId> providers;
};

/// Leaves in `ground` what a plan for the goal takes: which root tasks are asked for, which states are set, and what
/// its bodies answer. Other bodies do what is usual. Nothing expires, breaks, waits or fires.
void focus_on(Ground& ground, const Goal& goal);

} // namespace director::compiler
