// Header: compiler/analysis/clashes/losses.hpp. Test: compiler/checks/push_in_vain.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/clashes/losses.hpp"

#include "compiler/analysis/clashes/holdings.hpp"
#include "compiler/analysis/clashes/stopping.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::analysis {

using dsl::Note;

Losses::Because Losses::lost_request(ProviderId a, ProviderId b) const {
  const GroupId from = row(a).group, to = row(b).group;
  std::optional<GroupId> gate = graph_.gate[to];
  while (gate && *gate != from) gate = graph_.gate[*gate];
  if (!gate || leads_to(model_, shared_, a, to)) return std::nullopt;
  std::vector<Note> out;
  for (const EdgeId edge : model_.groups[to].requesters) {
    const std::optional<GroupId> requester = model_.edges[edge].requester;
    if (!requester || model_.edges[edge].levels.empty()) continue;
    for (const ProviderId id : model_.groups[*requester].providers) {
      const Task* task = find_entry(model_, id, to).task;
      if (task == nullptr || !facts_.active.contains(id)) continue;
      out.push_back(requests(model_, id, *task));
    }
  }
  return out;
}

Losses::Because Losses::lost_group(ProviderId a, ProviderId b) const {
  if (row(a).group == row(b).group) return std::nullopt;
  const GroupId victim = row(b).group;
  for (const Holding& taken : holdings_of(model_, shared_, a)) {
    if (taken.group == victim && taken.by_need && find_entry(model_, a, victim).task == nullptr)
      return std::vector<Note>{taken.note};
    for (const Holding& wanted : holdings_of(model_, shared_, b)) {
      if (wanted.group != taken.group || !wanted.by_need) continue;
      const bool first_wins = shared_.chains().may_beat(row(a).group, victim);
      const bool second_wins = shared_.chains().may_beat(victim, row(a).group);
      if (first_wins || (taken.by_need && !second_wins)) return std::vector<Note>{taken.note, wanted.note};
    }
  }
  return std::nullopt;
}

Losses::Because Losses::lost_provider(ProviderId a, ProviderId b, const Want& wanted) const {
  for (const auto& [state, accepted] : region_of(model_, row(b).when).states) {
    const ValueSet set = values_set_by(model_, row(a), state);
    if (set.empty() || set.overlaps(accepted) || comes_from_others(state, accepted, a, wanted)) continue;
    std::vector<Note> out;
    for (const std::vector<ConditionUse>* uses : {&row(a).causing, &row(a).sets}) {
      for (const ConditionUse& use : *uses) {
        if (model_.conditions[use.id].state != state) continue;
        out.push_back({use.span, fmt::format("{} makes {}", name_of(model_, a), name_of(model_, use.id))});
      }
    }
    for (const ConditionUse& use : row(b).when) {
      if (model_.conditions[use.id].state != state) continue;
      out.push_back(runs_only_while(model_, b, use));
    }
    return out;
  }
  return std::nullopt;
}

Losses::Because Losses::held_above(GroupId task, ProviderId causer) const {
  for (const Holding& wanted : holdings_of(model_, shared_, causer)) {
    if (!wanted.by_need) continue;
    for (std::optional<GroupId> above = graph_.gate[task]; above; above = graph_.gate[*above]) {
      const std::optional<Note> keeps = always_keeps(*above, task, wanted.group);
      if (keeps) return std::vector<Note>{wanted.note, *keeps};
    }
  }
  return std::nullopt;
}

bool Losses::comes_otherwise(const Want& want) const {
  const Condition& wanted = model_.conditions[want.condition.id];
  const std::vector<Source>& sources = sources_[wanted.state];
  return std::any_of(sources.begin(), sources.end(), [&](const Source& source) {
    if (source.kind == Source::Kind::initial || !source.values.overlaps(wanted.accepts)) return false;
    if (!source.provider) return true;
    const bool is_causer = std::find(want.causers.begin(), want.causers.end(), *source.provider) != want.causers.end();
    return !is_causer && facts_.active.contains(*source.provider) && !waits_too(*source.provider, want);
  });
}

std::optional<Note> Losses::always_keeps(GroupId group, GroupId task, GroupId kept) const {
  std::optional<Note> out;
  for (const ProviderId id : model_.groups[group].providers) {
    if (!facts_.active.contains(id) || !leads_to(model_, shared_, id, task)) continue;
    // It runs only while the conditions of what it needs hold.
    if (shared_.indispensable().needs_contain(row(id), task)) return std::nullopt;
    const std::vector<Holding> taken = holdings_of(model_, shared_, id);
    const auto at =
        std::find_if(taken.begin(), taken.end(), [&](const Holding& one) { return one.by_need && one.group == kept; });
    if (at == taken.end()) return std::nullopt;
    if (!out) out = at->note;
  }
  return out;
}

bool Losses::comes_from_others(StateId state, const ValueSet& values, ProviderId but, const Want& wanted) const {
  return std::any_of(sources_[state].begin(), sources_[state].end(), [&](const Source& source) {
    return source.kind != Source::Kind::initial && source.provider != but &&
           source.values.overlaps(values) && !(source.provider && waits_too(*source.provider, wanted));
  });
}

bool Losses::waits_too(ProviderId id, const Want& wanted) const {
  Stopping stopping(model_, facts_, sources_);
  stopping.suppose_lost(wanted.condition.id);
  return stopping.cannot_run(id, false);
}

} // namespace director::analysis
