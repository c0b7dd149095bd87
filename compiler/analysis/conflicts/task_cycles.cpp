// Header: compiler/analysis/conflicts/task_cycles.hpp. Test: compiler/checks/task_cycle.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/task_cycles.hpp"

#include "compiler/analysis/shared/shared.hpp"
#include "compiler/graph/algorithms.hpp"

#include <algorithm>

namespace director::analysis {

namespace {

/// `path` begins and ends with the same group.
TaskCycle cycle_of(const Shared& shared, std::vector<Node> path) {
  const auto begins_right = [&] {
    return shared.chains().always_below(GroupId{path[path.size() - 2]}, GroupId{path.front()});
  };
  bool is_known = begins_right();
  for (std::size_t turn = 1; !is_known && turn < path.size(); ++turn) {
    path.pop_back();
    std::rotate(path.begin(), path.begin() + 1, path.end());
    path.push_back(path.front());
    is_known = begins_right();
  }
  TaskCycle out{{}, is_known};
  for (const Node node : path) out.groups.push_back(GroupId{node});
  return out;
}

} // namespace

std::vector<TaskCycle> find_task_cycles(const Model& model, const Shared& shared) {
  std::vector<TaskCycle> out, loops;
  Arrows mandatory(model.groups.size());
  for (const Edge& edge : model.edges) {
    if (!edge.requester || edge.levels.empty()) continue;
    if (*edge.requester == edge.target)
      loops.push_back({{edge.target, edge.target}});
    else if (edge.has_mandatory())
      mandatory[edge.requester->value].push_back(edge.target.value);
  }
  for (const std::vector<Node>& nodes : cycles(mandatory))
    out.push_back(cycle_of(shared, shortest_path(mandatory, nodes[0], nodes[0])));
  out.insert(out.end(), loops.begin(), loops.end());
  return out;
}

} // namespace director::analysis
