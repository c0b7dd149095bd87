// Header: compiler/analysis/conflicts/starving.hpp. Test: compiler/checks/starved_task.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/starving.hpp"

#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/needs/units.hpp"
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
    if (lost.count(edge) != 0 || input.conflicts.closes_cycle(edge)) continue;
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
    add_chain(model, need_path(model, taker.by->target, taker.group), notes);
  }
  add_chain(model, need_path(model, task, taker.group), notes);
}

namespace {

/// Help for a mandatory task. A lower rank within one unit does not change that its needs are taken before anything
/// below is tried.
std::string propose(const Input& input, const Refused& refused, const Taker& taker) {
  const Model& model = input.model;
  if (taker.kind == Taker::Kind::above)
    return fmt::format("request it where {} is not above it", name_of(model, taker.holder));
  const GroupId task = refused.task->target, by = taker.by->target;
  const std::string elsewhere = fmt::format("request it where {} is not requested", name_of(model, by));
  if (taker.kind == Taker::Kind::unit) return elsewhere;
  const bool one_unit = shares_unit(model, *taker.by) && shares_unit(model, *taker.over);
  if (taker.over != refused.task)
    return one_unit ? elsewhere
                    : fmt::format("give {} a higher priority than {}, or {}", name_of(model, taker.over->target),
                                  name_of(model, by), elsewhere);
  // With the order reversed the other one would never run.
  const Indispensable& indispensable = input.shared.indispensable();
  const bool either =
      never_waits(input, task) && indispensable.contains(task, taker.group) && indispensable.contains(by, taker.group);
  return either ? elsewhere : "give it a higher priority, or " + elsewhere;
}

} // namespace

void report_starving_task(const Input& input, const StarvingTask& starving, Findings& findings) {
  const Model& model = input.model;
  const Refused& first = starving.places.front();
  const Taker& taker = starving.taker();
  const std::string name = name_of(model, first.task->target), requester = name_of(model, *first.requester);
  const auto taken_by = [&](const Taker& one) {
    return name_of(model, one.kind == Taker::Kind::above ? one.holder : one.by->target);
  };
  const std::string by = taken_by(taker), group = name_of(model, taker.group);
  dsl::Diagnostic& finding = findings.add(
      first.task->span,
      taker.kind == Taker::Kind::above
          ? fmt::format("{} never runs for {}: {}, which is above it, keeps {}", name, requester, by, group)
          : fmt::format(
                "{} never runs for {}: {}, which goes before it and never has to wait, is always requested with it "
                "and takes {}",
                name, requester, by, group));
  finding.rules_out = {first.task->span};
  add_taker(input, first, taker, finding.notes);
  std::set<const Task*> reported{first.task};
  for (std::size_t i = 1; i < starving.places.size(); ++i) {
    const Refused& place = starving.places[i];
    const Taker& one = place.refusals.front().taker;
    if (reported.insert(place.task).second)
      finding.notes.push_back({place.task->span, fmt::format("the same here, by {}, which takes {}", taken_by(one),
                                                             name_of(model, one.group))});
  }
  finding.help = starving.optional
                     ? fmt::format("request it where {} is not requested: what is optional goes after all "
                                   "that is mandatory",
                                   by)
                     : propose(input, first, taker);
}

} // namespace director::analysis
