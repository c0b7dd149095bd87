// Header: compiler/checks/check.hpp. Test: compiler/checks/self_conflict.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace director::checks {

namespace {

/// It asks for a group that is above it. Where nothing on the way is optional that is a cycle, another finding.
bool asks_above(const Loser& loser) { return loser.taker.group == loser.taker.holder; }

bool is_cycle(const Model& model, const Loser& loser) {
  const auto may_be_mandatory = [&](const ChainStep& step) {
    for (const ProviderId id : model.groups[step.from].providers) {
      for (const Pack& pack : model.providers[id].packs) {
        for (const Task& task : pack.tasks) {
          const std::vector<Level>& levels = model.edges[task.edge].levels;
          if (task.target == step.to && std::any_of(task.levels.begin(), task.levels.end(),
                                                    [&](const auto& named) { return !levels[named.level].optional; }))
            return true;
        }
      }
    }
    return false;
  };
  return loser.refused.task->target == loser.taker.holder &&
         (loser.chain.size() == 1 || std::all_of(loser.chain.begin(), loser.chain.end(), may_be_mandatory));
}

std::string message_of(const Model& model, const Loser& loser) {
  const std::string name = name_of(model, loser.refused.task->target);
  const std::string above = name_of(model, loser.above), kept = name_of(model, loser.taker.group);
  const std::string by = name_of(model, *loser.refused.requester);
  if (loser.taker.group == loser.refused.task->target && asks_above(loser))
    return fmt::format("{} never runs for {}, which is below {} itself", name, by, above);
  if (loser.refused.requester == loser.taker.holder)
    return fmt::format("{} never runs for {}, which keeps {} for itself", name, above, kept);
  return asks_above(loser)
             ? fmt::format("{} never runs for {} below {}, which it needs", name, by, above)
             : fmt::format("{} never runs for {} below {}, which keeps {} for itself", name, by, above, kept);
}

/// The need of the provider that comes down to the group.
const Use<GroupId>* find_need(const Model& model, const Loser& loser) {
  for (const Use<GroupId>& need : model.providers[loser.above].needs) {
    if (need.id == loser.taker.group || !need_path(model, need.id, loser.taker.group).empty()) return &need;
  }
  return nullptr;
}

} // namespace

void self_conflict(const Input& input, Findings& findings) {
  const Model& model = input.model;
  // The nearest one that loses something below an entry stands for all: what helps it helps the others.
  std::map<std::tuple<ProviderId, const Task*, GroupId>, std::vector<const Loser*>> all;
  for (const Loser& loser : input.conflicts.losers()) {
    if (loser.taker.kind != Taker::Kind::above || is_cycle(model, loser)) continue;
    // Elsewhere it may be asked for with a better chance, and then it is nobody's fault.
    if (asks_above(loser) && input.conflicts.grants().refused().count(loser.refused.task->edge) == 0) continue;
    const Task* place = asks_above(loser) ? loser.refused.task : loser.entry;
    all[{loser.above, place, loser.taker.group}].push_back(&loser);
  }
  for (const auto& [key, losers] : all) {
    const Loser& loser = *losers.front();
    const Use<GroupId>* need = find_need(model, loser);
    dsl::Diagnostic& finding = findings.add(std::get<const Task*>(key)->span, message_of(model, loser));
    for (const Loser* each : losers) finding.rules_out.push_back(each->refused.task->span);
    const std::string above = name_of(model, loser.above), kept = name_of(model, loser.taker.group);
    if (need != nullptr) {
      finding.notes.push_back({need->span, fmt::format("{} needs {}", above, name_of(model, need->id))});
      add_chain(model, need_path(model, need->id, loser.taker.group), finding.notes, dsl::Note::Link::next);
    }
    std::vector<ChainStep> chain = loser.chain;
    chain.erase(asks_above(loser) ? chain.end() - 1 : chain.begin()); // the finding stands there
    for (const ChainStep& step : need_path(model, loser.refused.task->target, loser.taker.group)) chain.push_back(step);
    add_chain(model, chain, finding.notes);
    for (std::size_t i = 1; i < losers.size(); ++i) {
      const Refused& other = losers[i]->refused;
      finding.notes.push_back({other.task->span, fmt::format("nor does {} for {}", name_of(model, other.task->target),
                                                             name_of(model, *other.requester))});
    }
    if (need == nullptr) {
      finding.help = fmt::format("ask for it where {} is not above it", kept);
    } else if (need->id == loser.taker.group && loser.entry->target != need->id) {
      finding.help = fmt::format("need {} instead of {}, or nothing: what a task needs is held when it is granted",
                                 name_of(model, loser.entry->target), kept);
    } else {
      finding.help = fmt::format("leave {} to {}, or do not need that: what a task needs is held when it is granted",
                                 kept, name_of(model, need->id));
    }
  }
}

} // namespace director::checks
