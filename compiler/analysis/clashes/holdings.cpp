// Header: compiler/analysis/clashes/holdings.hpp. Test: compiler/checks/push_in_vain.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/clashes/holdings.hpp"

#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace director::analysis {

namespace {

/// Whether each of its packs requests the same group as a mandatory task.
bool is_in_every_pack(const Model& model, const std::vector<Pack>& packs, const Task& task) {
  return std::all_of(packs.begin(), packs.end(), [&](const Pack& pack) {
    return std::any_of(pack.tasks.begin(), pack.tasks.end(), [&](const Task& other) {
      return other.target == task.target && !model.edges[other.edge].levels[other.levels.front().level].optional;
    });
  });
}

} // namespace

std::vector<Holding> holdings_of(const Model& model, const Shared& shared, ProviderId id) {
  const Provider& provider = model.providers[id];
  std::vector<Holding> out;
  const auto take = [&](GroupId group, dsl::Span span, bool by_need) {
    const std::string verb = by_need ? "needs" : "requests";
    const auto& parts = shared.indispensable().of(group);
    for (const GroupId part : parts ? *parts : std::vector<GroupId>{group}) {
      const std::string by = part == group ? "" : fmt::format(", which cannot do without {}", name_of(model, part));
      out.push_back(
          {part, {span, fmt::format("{} {} {}{}", name_of(model, id), verb, name_of(model, group), by)}, by_need});
    }
  };
  for (const Use<GroupId>& need : provider.needs) take(need.id, need.span, true);
  if (provider.packs.empty()) return out;
  for (const Task& task : provider.packs.front().tasks) {
    if (is_in_every_pack(model, provider.packs, task)) take(task.target, task.span, false);
  }
  return out;
}

std::optional<KeptNeed> find_kept_need(const Model& model, const Shared& shared, ProviderId above,
                                       ProviderId provider) {
  if (model.providers[above].needs.empty() || model.providers[provider].needs.empty()) return std::nullopt;
  const std::vector<Holding> kept = holdings_of(model, shared, above);
  for (Holding& needed : holdings_of(model, shared, provider)) {
    const auto at = std::find_if(kept.begin(), kept.end(), [&](const Holding& one) {
      return needed.by_need && one.by_need && one.group == needed.group;
    });
    if (at != kept.end()) return KeptNeed{needed.group, std::move(needed.note), at->note};
  }
  return std::nullopt;
}

bool leads_to(const Model& model, const Shared& shared, ProviderId provider, GroupId group) {
  for (const Pack& pack : model.providers[provider].packs) {
    for (const Task& task : pack.tasks) {
      if (task.target == group || shared.claims(task.target).contains(group)) return true;
    }
  }
  return false;
}

} // namespace director::analysis
