// Header: compiler/analysis/conflicts/conflicts.hpp. Test: tests/compiler/checks/pages_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/conflicts.hpp"

#include "compiler/analysis/shared/shared.hpp"

#include <algorithm>

namespace director::analysis {

const std::vector<Clash>& Conflicts::clashes() const {
  if (!clashes_) clashes_ = find_clashes(input_.model, input_.graph, input_.facts, input_.shared);
  return *clashes_;
}

const std::vector<PackConflict>& Conflicts::pack_conflicts() const {
  if (!pack_conflicts_) pack_conflicts_ = find_pack_conflicts(input_.model, input_.shared.units());
  return *pack_conflicts_;
}

const std::vector<TaskCycle>& Conflicts::task_cycles() const {
  if (!task_cycles_) task_cycles_ = find_task_cycles(input_.model, input_.shared);
  return *task_cycles_;
}

bool Conflicts::closes_cycle(EdgeId id) const {
  const Edge& edge = input_.model.edges[id];
  return std::any_of(task_cycles().begin(), task_cycles().end(), [&](const TaskCycle& cycle) {
    return cycle.is_known && edge.target == cycle.groups.back() && edge.requester == cycle.last_requester();
  });
}

Takers& Conflicts::takers() const {
  if (!takers_) takers_.emplace(input_);
  return *takers_;
}

Packmates& Conflicts::packmates() const {
  if (!packmates_) packmates_.emplace(input_, takers());
  return *packmates_;
}

const Grants& Conflicts::grants() const {
  if (!grants_) grants_.emplace(input_, takers(), packmates());
  return *grants_;
}

const std::vector<Loser>& Conflicts::losers() const {
  if (!losers_) losers_ = find_losers(input_, takers(), packmates());
  return *losers_;
}

const std::vector<Outranked>& Conflicts::outranked() const {
  if (!outranked_) outranked_ = find_outranked(input_);
  return *outranked_;
}

const std::vector<HeldPush>& Conflicts::held_pushes() const {
  if (!held_pushes_) held_pushes_ = find_held_pushes(input_);
  return *held_pushes_;
}

const std::vector<StarvingTask>& Conflicts::starving_tasks() const {
  if (!starving_tasks_) starving_tasks_ = find_starving_tasks(input_);
  return *starving_tasks_;
}

} // namespace director::analysis
