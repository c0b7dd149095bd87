// Header: compiler/analysis/rounds/spoiling.hpp. Test: compiler/checks/undone_by_fallback.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/rounds/spoiling.hpp"

#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace director::analysis {

std::optional<Spoilt> Spoiling::of(ProviderId causer, ConditionId wanted) const {
  const compiler::Provider& row = model_.providers[causer];
  if (row.when.empty()) return std::nullopt;
  if (!entries_) find_entries();
  const Region runs = active_region(model_, row);
  for (const ConditionUse& use : row.when) {
    const StateId state = model_.conditions[use.id].state;
    const auto at = runs.states.find(state);
    if (at == runs.states.end() || state == model_.conditions[wanted].state) continue;
    const auto entries = entries_->find(state);
    if (entries == entries_->end()) continue;
    for (const Entry& entry : entries->second) {
      const ValueSet& set = model_.conditions[entry.set.id].accepts;
      if (set.overlaps(at->second)) continue;
      std::optional<dsl::Note> back = stop_that_causes(model_, entry.group, use.id);
      if (!back) back = stop_that_causes(model_, granted_.task, use.id);
      if (!back) break; // it is lost for good
      Spoilt out{use, set, {}};
      if (entry.group != granted_.task) add_chain(model_, granted_.below.path(entry.group), out.notes);
      out.notes.push_back(note_of(entry));
      out.notes.push_back(std::move(*back));
      return out;
    }
  }
  return std::nullopt;
}

void Spoiling::find_entries() const {
  entries_.emplace();
  if (granted_.pushed) return; // its group goes on with another provider
  const Region here = region_of(model_, model_.providers[runs_].when);
  add_group(granted_.task, here, granted_.is_other() ? std::nullopt : std::optional(runs_));
  for (const GroupId group : granted_.below.groups()) {
    if (group != granted_.task && stops_with_task(group)) add_group(group, here, {});
  }
}

void Spoiling::add(GroupId group, const std::vector<ConditionUse>& entries, std::optional<ProviderId> by,
                   bool promised) const {
  for (const ConditionUse& entry : entries)
    (*entries_)[model_.conditions[entry.id].state].push_back({group, entry, by, promised});
}

dsl::Note Spoiling::note_of(const Entry& entry) const {
  const std::string by =
      entry.by ? name_of(model_, *entry.by) : fmt::format("the start of {}", name_of(model_, entry.group));
  return {entry.set.span,
          fmt::format("{} may {} {}", by, entry.promised ? "cause" : "set", name_of(model_, entry.set.id))};
}

/// What its start sets, and its providers; of the task itself, not what it causes, because it is done then.
void Spoiling::add_group(GroupId group, const Region& here, std::optional<ProviderId> runs) const {
  const Group& row = model_.groups[group];
  if (row.start) add(group, row.start->sets, {}, false);
  for (const ProviderId id : row.providers) {
    const compiler::Provider& provider = model_.providers[id];
    if (runs ? id != *runs : !facts_.active.contains(id) || !compatible(here, active_region(model_, provider)))
      continue;
    add(group, provider.sets, id, false);
    if (group != granted_.task) add(group, provider.causing, id, true);
  }
}

/// Whether only what runs below the task requests it.
bool Spoiling::stops_with_task(GroupId group) const {
  const std::vector<EdgeId>& all = model_.groups[group].requesters;
  return std::all_of(all.begin(), all.end(), [&](EdgeId id) {
    const std::optional<GroupId>& requester = model_.edges[id].requester;
    return requester && (*requester == granted_.task || granted_.below.contains(*requester));
  });
}

} // namespace director::analysis
