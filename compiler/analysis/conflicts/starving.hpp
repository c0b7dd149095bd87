#pragma once
// SPDX-License-Identifier: MIT
// Tasks that never run because something that goes before them is always requested with them and takes what they must
// have.

#include "compiler/analysis/conflicts/grants.hpp"
#include "compiler/analysis/findings.hpp"
#include "compiler/analysis/input.hpp"

#include <vector>

namespace director::analysis {

struct StarvingTask {
  std::vector<Refused> places; ///< everywhere where this requester asks for it; never empty
  bool optional = false;       ///< the first of these entries is
  const Taker& taker() const { return places.front().refusals.front().taker; }
};

/// Of tasks that are never granted those that no loser is, and that close no circle, in order of edges.
std::vector<StarvingTask> find_starving_tasks(const Input& input);

void report_starving_task(const Input& input, const StarvingTask& starving, Findings& findings);

/// The reason why a task never gets what is held before, in notes: who takes it, and by what chains both come to it.
void add_taker(const Input& input, const Refused& refused, const Taker& taker, std::vector<dsl::Note>& notes);

} // namespace director::analysis
