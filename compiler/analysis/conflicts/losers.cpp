// Header: compiler/analysis/conflicts/losers.hpp. Test: compiler/checks/self_conflict.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/losers.hpp"

#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/shared/shared.hpp"

#include <algorithm>
#include <optional>

namespace director::analysis {

namespace {

/// Limit for the packs visited below all others. A real behaviour of 10,000 groups takes a tenth.
constexpr std::size_t most_visits = 100'000;

/// Whether something that is held from the beginning may be wanted again further down.
bool is_worth_a_look(const Input& input, Takers& takers, ProviderId id, const Pack& pack) {
  const Provider& provider = input.model.providers[id];
  std::map<GroupId, const Task*> held; ///< by which entry, if only by one
  for (const GroupId group : takers.must(id)) {
    if (takers.is_contested(group)) held[group] = nullptr;
  }
  if (provider.has_packs && pack.tasks.size() > 1) {
    const Unit unit = unit_members(input.model, pack);
    for (const Task* member : unit) {
      for (const GroupId group : takers.must(member->target)) {
        if (unit.size() > 1 && takers.is_contested(group) && !held.try_emplace(group, member).second)
          held[group] = nullptr;
      }
    }
  }
  return !held.empty() && std::any_of(pack.tasks.begin(), pack.tasks.end(), [&](const Task& task) {
    const Groups& wanted = input.shared.claims(task.target).groups();
    return std::any_of(held.begin(), held.end(),
                       [&](const auto& entry) { return entry.second != &task && has(wanted, entry.first); });
  });
}

/// The taker if this pack or its owner is the cause; null if neither is.
const Taker* find_own(const Refused& refused, GroupId above, const Pack& pack) {
  for (const Refusal& refusal : refused.refusals) {
    const Taker& taker = refusal.taker;
    if (taker.kind == Taker::Kind::before) continue;
    const bool is_ours =
        taker.kind == Taker::Kind::above
            ? taker.holder == above
            : std::any_of(pack.tasks.begin(), pack.tasks.end(), [&](const Task& task) { return &task == taker.by; });
    if (is_ours) return &taker;
  }
  return nullptr;
}

bool is_only_one(const Input& input, ProviderId id) {
  const std::vector<ProviderId>& all = input.model.groups[input.model.providers[id].group].providers;
  return std::all_of(all.begin(), all.end(),
                     [&](ProviderId each) { return each == id || !input.facts.active.contains(each); });
}

} // namespace

std::vector<Loser> find_losers(const Input& input, Takers& takers, Packmates& packmates) {
  std::size_t visits = 0;
  const Model& model = input.model;
  std::vector<Loser> out;
  for (const ProviderId id : model.providers.ids()) {
    if (!input.facts.active.contains(id)) continue;
    const GroupId group = model.providers[id].group;
    for (const Pack& pack : model.providers[id].packs) {
      if (!is_worth_a_look(input, takers, id, pack)) continue;
      if (visits > most_visits) continue;
      const Grants grants(input, takers, packmates, id, pack, Grants::Running::above);
      visits += grants.visits();
      std::optional<Grants> kept; ///< while any provider of the group runs, computed if there are losers
      const auto loses_if_kept = [&](EdgeId edge) {
        if (is_only_one(input, id) || input.conflicts.grants().refused().count(edge) != 0) return true;
        if (!kept) visits += kept.emplace(input, takers, packmates, id, pack, Grants::Running::any).visits();
        return kept->refused().count(edge) != 0;
      };
      for (const auto& [edge, all] : grants.refused()) {
        for (const Refused& refused : all) {
          const Taker* taker = find_own(refused, group, pack);
          if (taker == nullptr) continue;
          Loser loser{id, nullptr, refused, *taker, {}, !loses_if_kept(edge)};
          if (refused.requester != group) loser.chain = grants.chain_to(*refused.requester);
          loser.chain.push_back({*refused.requester, refused.task->target, false, refused.task->span});
          const GroupId first = loser.chain.front().to;
          const auto entry = std::find_if(pack.tasks.begin(), pack.tasks.end(),
                                          [&](const Task& task) { return task.target == first; });
          if (entry == pack.tasks.end()) continue; // it is reached again, by another of its packs
          loser.entry = &*entry;
          out.push_back(std::move(loser));
          break;
        }
      }
    }
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Loser& a, const Loser& b) { return a.chain.size() < b.chain.size(); });
  return out;
}

} // namespace director::analysis
