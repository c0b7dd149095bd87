// Header: compiler/checks/check.hpp. Test: compiler/checks/causer_goes_first.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/conflicts/outranked.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::checks {

namespace {

/// With several levels the one that decides: the lowest of what goes first, the highest of what waits.
std::string rank_of(const Model& model, const Task& task, bool lowest) {
  const auto level_of = [&](const Task::NamedLevel& named) { return model.edges[task.edge].levels[named.level]; };
  const auto comes_before = [&](const Task::NamedLevel& a, const Task::NamedLevel& b) {
    const compiler::Level left = level_of(a), right = level_of(b);
    return left.optional == right.optional ? left.priority < right.priority : left.optional;
  };
  const compiler::Level level =
      level_of(lowest ? *std::min_element(task.levels.begin(), task.levels.end(), comes_before)
                      : *std::max_element(task.levels.begin(), task.levels.end(), comes_before));
  return level.optional ? "is optional" : fmt::format("has priority {}", level.priority);
}

} // namespace

void causer_goes_first(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const Outranked& one : input.conflicts.outranked()) {
    const std::string waits = name_of(model, one.waits->target);
    const std::string reason = one.need != nullptr
                                   ? fmt::format("{} needs {}, which nothing below it can push",
                                                 name_of(model, *one.needer), name_of(model, one.need->id))
                                   : fmt::format("{} does not rank after {}", name_of(model, one.first->target), waits);
    dsl::Diagnostic& finding = findings.add(
        one.request->span, fmt::format("{} may wait here for {}, and pushes no group for it: {}",
                                       name_of(model, one.request->target), name_of(model, one.condition.id), reason));
    finding.rules_out = {one.condition.span};
    finding.help = propose_going_first(model, one);
    finding.notes.push_back({one.condition.span, fmt::format("{} waits for this", name_of(model, one.waiter))});
    for (const ProviderId id : one.causers) finding.notes.push_back(causes(model, id, one.condition.id));
    if (one.need != nullptr) {
      finding.notes.push_back(
          {one.need->span, fmt::format("{} needs {}", name_of(model, *one.needer), name_of(model, one.need->id))});
      continue;
    }
    const std::string first = name_of(model, one.first->target);
    const GroupId causing = model.providers[one.causers.front()].group;
    const std::string way =
        one.first->target == causing ? "" : fmt::format(", which leads to {},", name_of(model, causing));
    finding.notes.push_back({one.first->span, fmt::format("{}{} {}", first, way, rank_of(model, *one.first, true))});
    finding.notes.push_back({one.waits->span, fmt::format("and {} {}", waits, rank_of(model, *one.waits, false))});
  }
}

} // namespace director::checks
