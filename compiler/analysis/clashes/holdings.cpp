// Header: compiler/analysis/clashes/holdings.hpp. Test: compiler/checks/push_in_vain.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/clashes/holdings.hpp"

#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/words.hpp"

#include <fmt/format.h>

#include <algorithm>

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

std::vector<KeptNeed> find_kept_needs(const Model& model, const Shared& shared, ProviderId above,
                                      const std::vector<ProviderId>& providers) {
  const auto has_needs = [&](ProviderId id) { return !model.providers[id].needs.empty(); };
  if (!has_needs(above) || !std::all_of(providers.begin(), providers.end(), has_needs)) return {};
  const std::vector<Holding> kept = holdings_of(model, shared, above);
  const auto kept_like = [&](const Holding& needed) {
    return std::find_if(kept.begin(), kept.end(),
                        [&](const Holding& one) { return needed.by_need && one.by_need && one.group == needed.group; });
  };
  std::vector<KeptNeed> out;
  for (const ProviderId id : providers) {
    const std::vector<Holding> all = holdings_of(model, shared, id);
    const auto needed =
        std::find_if(all.begin(), all.end(), [&](const Holding& each) { return kept_like(each) != kept.end(); });
    if (needed == all.end()) return {};
    out.push_back({needed->group, needed->note, kept_like(*needed)->note});
  }
  return out;
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
