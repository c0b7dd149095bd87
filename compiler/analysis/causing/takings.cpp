// Header: compiler/analysis/causing/takings.hpp. Test: compiler/checks/undone_by_fallback.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/takings.hpp"

#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace director::analysis {

void add_taking(const Model& model, const Want& want, dsl::Note source, Taking how, dsl::Diagnostic& finding) {
  finding.rules_out = std::move(how.requests);
  finding.rules_out.push_back(want.condition.span);
  add_waiter(model, want, finding.notes);
  finding.notes.push_back(std::move(source));
  for (dsl::Note& note : how.notes) finding.notes.push_back(std::move(note));
}

std::vector<const Use<GroupId>*> Takings::needs_taken(ProviderId id) const {
  std::vector<const Use<GroupId>*> out;
  for (const Use<GroupId>& need : model_.providers[id].needs) {
    if (part_taken(model_.providers[id].group, need.id)) out.push_back(&need);
  }
  return out;
}

const Use<GroupId>* Takings::need_taken(ProviderId id) const {
  const Provider& row = model_.providers[id];
  const auto at = std::find_if(row.needs.begin(), row.needs.end(),
                               [&](const Use<GroupId>& need) { return part_taken(row.group, need.id).has_value(); });
  return at == row.needs.end() ? nullptr : &*at;
}

Taking Takings::way_to(const Use<GroupId>& need, GroupId of) const {
  Taking out;
  const std::optional<GroupId> taken = part_taken(of, need.id);
  if (!taken) return out;
  if (*taken == task_) {
    out.notes.push_back({model_.groups[task_].name.span, fmt::format("{} is taken", name_of(model_, task_))});
    return out;
  }
  const std::vector<ChainStep> path = claims_.path(*taken, *find_taking(of, *taken));
  add_chain(model_, path, out.notes);
  for (const ChainStep& step : path) {
    if (!step.by_need) out.requests.push_back(step.span);
  }
  return out;
}

bool Takings::may_beat(GroupId group) const {
  return ranks_ == nullptr || ranks_->may_beat(unit_, group) || (task_ != unit_ && ranks_->may_beat(task_, group));
}

/// The first in which the task holds the group and takes it from the other one.
std::optional<Reach> Takings::find_taking(GroupId loser, GroupId group) const {
  if (!claims_.contains(group)) return std::nullopt;
  const auto reach = std::find_if(std::begin(all_reaches), std::end(all_reaches), [&](Reach each) {
    return claims_.find(group, each) != nullptr && goes_before(each, loser);
  });
  return reach == std::end(all_reaches) ? std::nullopt : std::optional(*reach);
}

/// What the task needs itself is claimed with the whole unit, at the place of its first member; what it requests, by
/// the rank of the task.
bool Takings::goes_before(Reach reach, GroupId loser) const {
  if (ranks_ == nullptr) return true;
  if (reach == Reach::own) return !is_held_ && may_beat(loser);
  return ranks_->may_beat(task_, loser, reach == Reach::optional);
}

std::optional<GroupId> Takings::part_taken(GroupId loser, GroupId needed) const {
  if (takes_from(loser, needed)) return needed;
  const auto& parts = indispensable_.of(needed);
  if (!parts) return std::nullopt;
  const auto at = std::find_if(parts->begin(), parts->end(), [&](GroupId part) { return takes_from(loser, part); });
  if (at == parts->end()) return std::nullopt;
  return *at;
}

} // namespace director::analysis
