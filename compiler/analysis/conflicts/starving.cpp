// Header: compiler/analysis/conflicts/starving.hpp. Test: compiler/checks/starved_task.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/starving.hpp"

#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/requests/gaps.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace director::analysis {

std::vector<StarvingTask> find_starving_tasks(const Input& input) {
  std::set<EdgeId> lost;
  for (const Loser& loser : input.conflicts.losers()) lost.insert(loser.refused.task->edge);
  std::vector<StarvingTask> out;
  for (const auto& [edge, places] : input.conflicts.grants().refused()) {
    if (lost.count(edge) != 0 || input.conflicts.closes_cycle(edge) || input.facts.excludes(edge)) continue;
    StarvingTask starving{places, false};
    // If only one entry has another reason, the reason `before` explains more.
    std::stable_partition(starving.places.begin(), starving.places.end(), [](const Refused& refused) {
      return refused.refusals.front().taker.kind == Taker::Kind::before;
    });
    const std::vector<Level>& levels = input.model.edges[edge].levels;
    starving.optional = std::all_of(levels.begin(), levels.end(), [](const Level& level) { return level.optional; });
    out.push_back(std::move(starving));
  }
  return out;
}

bool never_waits(const Input& input, GroupId task) {
  Ways ways(input.model, input.facts, false, [](ProviderId, const ConditionUse&) { return true; });
  return find_covering(input.model, Region{}, ways.of(task), input.facts.values, input.shared.budget()) ==
         Covering::covered;
}

void add_taker(const Input& input, const Refused& refused, const Taker& taker, std::vector<dsl::Note>& notes) {
  const Model& model = input.model;
  const GroupId task = refused.task->target;
  if (taker.kind == Taker::Kind::above) {
    add_chain(model, need_path(model, taker.holder, taker.group), notes);
  } else {
    const std::string by = name_of(model, taker.by->target);
    notes.push_back({taker.by->span, fmt::format("{} is requested here", by)});
    if (taker.over != refused.task)
      notes.push_back({taker.over->span, fmt::format("and goes before {}, which leads to {}",
                                                     name_of(model, taker.over->target), name_of(model, task))});
    if (const Task* const leader = taker.led_by())
      notes.push_back({leader->span, fmt::format("{} is granted together with {}, and goes before {}",
                                                 name_of(model, leader->target), by,
                                                 name_of(model, taker.over->target))});
    add_chain(model, need_path(model, taker.by->target, taker.group), notes);
  }
  add_chain(model, need_path(model, task, taker.group), notes);
}

} // namespace director::analysis
