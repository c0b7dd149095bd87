#pragma once
// SPDX-License-Identifier: MIT
// Finds tasks that never run because a task that goes before them is always requested with them and takes what they
// must have.

#include "compiler/analysis/conflicts/grants.hpp"
#include "compiler/analysis/input.hpp"
#include "dsl/source/diagnostic.hpp"

#include <vector>

namespace director::analysis {

struct StarvingTask {
  std::vector<Refused> places; ///< all entries of this requester for it; never empty
  bool optional = false;       ///< all levels of these entries are
  const Taker& taker() const { return places.front().refusals.front().taker; }
};

/// Of the tasks that are never granted those that are no loser and close no cycle, in order of edges.
std::vector<StarvingTask> find_starving_tasks(const Input& input);

/// Whether the conditions of some provider of it are true at any time.
bool never_waits(const Input& input, GroupId task);

/// Adds notes that explain why a task never gets what is held before: what takes it, and the chains of both.
void add_taker(const Input& input, const Refused& refused, const Taker& taker, std::vector<dsl::Note>& notes);

} // namespace director::analysis
