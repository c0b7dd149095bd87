// Header: compiler/checks/check.hpp. Test: compiler/checks/self_conflict.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/conflicts/contenders.hpp"
#include "compiler/analysis/conflicts/starving.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace director::checks {

namespace {

/// Whether it requests a group that is above it. Without an optional request in between that is a cycle, another
/// finding.
bool requests_above(const Loser& loser) { return loser.taker.group == loser.taker.holder; }

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

/// Where it also requests what it needs above it, the cycle is the finding.
bool closes_cycle_itself(const Input& input, const Loser& loser) {
  const std::vector<TaskCycle>& all = input.conflicts.task_cycles();
  return requests_above(loser) && std::any_of(all.begin(), all.end(), [&](const TaskCycle& cycle) {
           return cycle.last_requester() == loser.refused.task->target && cycle.groups.back() == loser.taker.holder;
         });
}

/// Where it is granted only together with what the provider needs, the conflict of the pack is the finding.
bool is_pack_conflict(const Input& input, const Loser& loser) {
  if (!input.model.providers[loser.above].has_packs || loser.chain.size() != 1) return false;
  const std::vector<PackConflict>& all = input.conflicts.pack_conflicts();
  return std::any_of(all.begin(), all.end(), [&](const PackConflict& conflict) {
    if (conflict.provider != loser.above || conflict.verdict != UnitVerdict::impossible) return false;
    const auto kept_off = find_kept_off(input, conflict);
    return kept_off && kept_off->member == loser.refused.task;
  });
}

std::string message_of(const Model& model, const Loser& loser) {
  const std::string name = name_of(model, loser.refused.task->target);
  const std::string above = name_of(model, loser.above), kept = name_of(model, loser.taker.group);
  const std::string by = name_of(model, *loser.refused.requester);
  const bool is_direct = loser.refused.requester == loser.taker.holder; // no other group in between
  if (requests_above(loser)) {
    const std::string holder = name_of(model, loser.taker.holder);
    if (loser.taker.group == loser.refused.task->target)
      return fmt::format("{} never runs for {}, which is below {} itself", name, by, holder);
    return is_direct ? fmt::format("{} never runs for {}, which it needs", name, by)
                     : fmt::format("{} never runs for {} below {}, which it needs", name, by, holder);
  }
  if (loser.only_while_above) {
    const std::string group = name_of(model, model.providers[loser.above].group);
    return is_direct ? fmt::format("{} never runs for {} while {} keeps {} for itself", name, group, above, kept)
                     : fmt::format("{} never runs for {} below {} while {} keeps {} for itself", name, by, group, above,
                                   kept);
  }
  return is_direct ? fmt::format("{} never runs for {}, which keeps {} for itself", name, above, kept)
                   : fmt::format("{} never runs for {} below {}, which keeps {} for itself", name, by, above, kept);
}

/// A provider that may keep the requests of the one above, and does not always hold the group.
std::optional<ProviderId> find_keeper(const Input& input, const Loser& loser) {
  const Model& model = input.model;
  for (const ProviderId id : model.groups[model.providers[loser.above].group].providers) {
    if (id != loser.above && input.facts.active.contains(id) &&
        !input.shared.indispensable().needs_contain(model.providers[id], loser.taker.group))
      return id;
  }
  return std::nullopt;
}

/// The provider's need that leads to the group.
const Use<GroupId>* find_need(const Model& model, const Loser& loser) {
  for (const Use<GroupId>& need : model.providers[loser.above].needs) {
    if (needs_lead_to(model, need.id, loser.taker.group)) return &need;
  }
  return nullptr;
}

/// The place of the finding.
const Task& place_of(const Loser& loser) { return requests_above(loser) ? *loser.refused.task : *loser.entry; }

/// Those that lose one group to one provider, below one entry. The nearest one, the first, represents all: what helps
/// it helps the others.
using Losers = std::vector<const Loser*>;

/// Tasks that lose the same group below other entries, or other providers of the group, are reported with the first
/// one.
std::vector<std::vector<Losers>> losers_by_place(const Input& input) {
  std::map<std::tuple<ProviderId, dsl::Span, GroupId, bool>, Losers> by_entry;
  for (const Loser& loser : input.conflicts.losers()) {
    const EdgeId edge = loser.refused.task->edge;
    if (loser.taker.kind != Taker::Kind::above || is_cycle(input.model, loser) || input.facts.excludes(edge)) continue;
    if (input.conflicts.closes_cycle(edge) || closes_cycle_itself(input, loser) || is_pack_conflict(input, loser))
      continue;
    // Another request for it may have a better chance; then this is no fault.
    if (requests_above(loser) && input.conflicts.grants().refused().count(edge) == 0) continue;
    by_entry[{loser.above, place_of(loser).span, loser.taker.group, loser.only_while_above}].push_back(&loser);
  }
  std::map<std::tuple<bool, EdgeId, GroupId, GroupId, bool>, std::size_t> places;
  std::vector<std::vector<Losers>> out;
  for (auto& [key, losers] : by_entry) {
    const Loser& first = *losers.front();
    // How many tasks request a group above them does not matter.
    const auto holder = requests_above(first) ? GroupId{} : first.taker.holder;
    const auto kept = requests_above(first) ? GroupId{} : first.taker.group;
    const auto [at, is_new] = places.try_emplace(
        {requests_above(first), first.refused.task->edge, holder, kept, first.only_while_above}, out.size());
    if (is_new) out.emplace_back();
    out[at->second].push_back(std::move(losers));
  }
  return out;
}

void add_same(const Model& model, const Loser& first, const Loser& other, dsl::Diagnostic& finding) {
  const auto is_reported = [&](dsl::Span span) {
    return span == finding.span || std::any_of(finding.notes.begin(), finding.notes.end(),
                                               [&](const dsl::Note& note) { return note.span == span; });
  };
  if (requests_above(other) && other.taker.holder != first.taker.holder) {
    finding.notes.push_back(
        {other.entry->span, fmt::format("nor below {}, which leads to it here", name_of(model, other.taker.holder))});
  } else if (!is_reported(place_of(other).span)) {
    finding.notes.push_back(
        {place_of(other).span, other.above == first.above
                                   ? std::string("the same here")
                                   : fmt::format("the same here, below {}", name_of(model, other.above))});
  }
}

/// What the provider may need instead of the group that it keeps: the requested task, which takes with it what it
/// needs.
std::string propose_need(const Input& input, const Loser& loser) {
  const Model& model = input.model;
  const GroupId task = loser.entry->target;
  std::vector<std::string> instead, conflicting;
  bool conflict = input.facts.may_wait.contains(task) || // if it needed that, it would wait with it
                  is_pushed_below(input, model.providers[loser.above], task);
  for (const Use<GroupId>& need : model.providers[loser.above].needs) {
    if (need.id == task) continue;
    const bool is_shared = !input.shared.indispensable().in_common(need.id, task).empty();
    if (need.id == loser.taker.group || is_shared) conflicting.push_back(name_of(model, need.id));
    if (need.id == loser.taker.group || input.shared.claims(task).contains(need.id)) {
      instead.push_back(name_of(model, need.id));
    } else if (is_shared) {
      conflict = true;
    }
  }
  if (conflict) return fmt::format("do not need {}", list_of(conflicting, "or"));
  return fmt::format("need {} instead of {}, or {}", name_of(model, task), list_of(instead, "and"),
                     instead.size() == 1 ? "nothing" : "none of them");
}

void report(const Input& input, const std::vector<Losers>& all, Findings& findings) {
  const Model& model = input.model;
  const Losers& losers = all.front();
  const Loser& loser = *losers.front();
  const Use<GroupId>* need = find_need(model, loser);
  dsl::Diagnostic& finding = findings.add(place_of(loser).span, message_of(model, loser));
  const std::string above = name_of(model, loser.above), kept = name_of(model, loser.taker.group);
  if (need != nullptr) {
    finding.notes.push_back({need->span, fmt::format("{} needs {}", above, name_of(model, need->id))});
    add_chain(model, need_path(model, need->id, loser.taker.group), finding.notes, dsl::Note::Link::next);
  }
  if (const auto keeper = loser.only_while_above ? find_keeper(input, loser) : std::nullopt)
    finding.notes.push_back({model.providers[*keeper].span,
                             fmt::format("{} may run while {} runs, if that keeps the request",
                                         name_of(model, loser.refused.task->target), name_of(model, *keeper))});
  std::vector<ChainStep> chain = loser.chain;
  chain.erase(requests_above(loser) ? chain.end() - 1 : chain.begin()); // that is the place of the finding
  for (const ChainStep& step : need_path(model, loser.refused.task->target, loser.taker.group)) chain.push_back(step);
  add_chain(model, chain, finding.notes);
  // What keeps its other providers from running.
  for (const Taker& other : loser.refused.together) {
    if (other.kind != Taker::Kind::above || other.group != loser.taker.group)
      add_taker(input, loser.refused, other, finding.notes);
  }
  for (const Losers& each : all) {
    if (&each != &losers) add_same(model, loser, *each.front(), finding);
    for (const Loser* other : each) {
      if (!other->only_while_above) finding.rules_out.push_back(other->refused.task->span);
    }
  }
  std::set<EdgeId> reported{loser.refused.task->edge};
  for (const Losers& each : all) {
    for (const Loser* other : each) {
      if (reported.insert(other->refused.task->edge).second)
        finding.notes.push_back(
            {other->refused.task->span, fmt::format("nor does {} for {}", name_of(model, other->refused.task->target),
                                                    name_of(model, *other->refused.requester))});
    }
  }
  if (need == nullptr) {
    finding.help = fmt::format("request it where {} is not above it", kept);
  } else if (need->id == loser.taker.group && loser.entry->target != need->id) {
    finding.help = propose_need(input, loser) + ": what a task needs is held when it is granted";
  } else {
    finding.help = fmt::format("leave {} to {}, or do not need that: what a task needs is held when it is granted",
                               kept, name_of(model, need->id));
  }
}

} // namespace

void self_conflict(const Input& input, Findings& findings) {
  for (const std::vector<Losers>& all : losers_by_place(input)) report(input, all, findings);
}

} // namespace director::checks
