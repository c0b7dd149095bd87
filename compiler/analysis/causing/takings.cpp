// Header: compiler/analysis/causing/takings.hpp. Test: compiler/checks/undone_by_fallback.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/takings.hpp"

#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
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
    if (part_taken(need.id)) out.push_back(&need);
  }
  return out;
}

const Use<GroupId>* Takings::need_taken(ProviderId id) const {
  const std::vector<Use<GroupId>>& needs = model_.providers[id].needs;
  const auto at = std::find_if(needs.begin(), needs.end(),
                               [&](const Use<GroupId>& need) { return part_taken(need.id).has_value(); });
  return at == needs.end() ? nullptr : &*at;
}

Taking Takings::way_to(const Use<GroupId>& need) const {
  Taking out;
  const std::optional<GroupId> taken = part_taken(need.id);
  if (!taken) return out;
  if (*taken == task_) {
    out.notes.push_back({model_.groups[task_].name.span, fmt::format("{} is taken", name_of(model_, task_))});
    return out;
  }
  const std::vector<ChainStep> path = claims_.path(*taken);
  add_chain(model_, path, out.notes);
  for (const ChainStep& step : path) {
    if (!step.by_need) out.requests.push_back(step.span);
  }
  return out;
}

std::optional<GroupId> Takings::part_taken(GroupId needed) const {
  if (takes(needed)) return needed;
  const auto& parts = indispensable_.of(needed);
  if (!parts) return std::nullopt;
  const auto at = std::find_if(parts->begin(), parts->end(), [&](GroupId part) { return takes(part); });
  if (at == parts->end()) return std::nullopt;
  return *at;
}

} // namespace director::analysis
