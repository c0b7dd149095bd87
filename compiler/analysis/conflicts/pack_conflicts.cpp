// Header: compiler/analysis/conflicts/pack_conflicts.hpp. Test: compiler/checks/pack_conflict.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/pack_conflicts.hpp"

#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/words/reported_pairs.hpp"

#include <algorithm>

namespace director::analysis {

namespace {

std::vector<GroupId> targets_of(const std::vector<const Task*>& members) {
  std::vector<GroupId> out;
  for (const Task* member : members) out.push_back(member->target);
  return out;
}

/// Whether it can be granted with no other member.
bool is_impossible_alone(Units& units, GroupId member) {
  bool found = false;
  const bool complete = units.visit({member}, false, [&](const Combination&) {
    found = true;
    return false;
  });
  return complete && !found;
}

/// Whether one member can never be granted because of itself alone. If members want the same groups, it is not.
bool is_fault_of_one(Units& units, const std::vector<GroupId>& members) {
  return std::any_of(members.begin(), members.end(),
                     [&](GroupId member) { return is_impossible_alone(units, member); }) &&
         units.verdict(members, true) != UnitVerdict::impossible;
}

} // namespace

std::vector<GroupId> PackConflict::targets() const { return targets_of(members); }

std::vector<PackConflict> find_pack_conflicts(const Model& model, Units& units) {
  std::vector<PackConflict> out;
  for (const ProviderId id : model.providers.ids()) {
    for (const Pack& pack : model.providers[id].packs) {
      const std::vector<const Task*> members = unit_members(model, pack);
      if (members.size() < 2) continue;
      const std::vector<GroupId> targets = targets_of(members);
      const UnitVerdict whole = units.verdict(targets);
      if (whole == UnitVerdict::possible) continue;
      const std::size_t before = out.size();
      for (std::size_t j = 1; j < members.size(); ++j) {
        for (std::size_t i = 0; i < j; ++i) {
          const GroupId a = members[i]->target, b = members[j]->target;
          if (a == b || units.verdict({a, b}) != UnitVerdict::impossible || is_fault_of_one(units, {a, b})) continue;
          out.push_back({id, &pack, {members[i], members[j]}, UnitVerdict::impossible});
          if (members.size() > longest_with_all_pairs) break; // each but the first is reported once
        }
      }
      if (out.size() == before && model.providers[id].has_packs &&
          (whole == UnitVerdict::undecided || !is_fault_of_one(units, targets)))
        out.push_back({id, &pack, members, whole});
    }
  }
  return out;
}

std::optional<KeptOff> find_kept_off(const Input& input, const PackConflict& conflict) {
  const std::vector<const Task*>& members = conflict.members;
  const auto is_other_member = [&](const Task* loser, GroupId group) {
    return std::any_of(members.begin(), members.end(),
                       [&](const Task* member) { return member != loser && member->target == group; });
  };
  for (const Loser& loser : input.conflicts.losers()) {
    const Task* task = loser.refused.task;
    const GroupId kept = loser.taker.group;
    if (loser.above != conflict.provider || loser.taker.kind != Taker::Kind::above) continue;
    if (std::find(members.begin(), members.end(), task) == members.end()) continue;
    for (const Use<GroupId>& need : input.model.providers[conflict.provider].needs) {
      if (!is_other_member(task, need.id)) continue;
      if (needs_lead_to(input.model, need.id, kept)) return KeptOff{task, kept, &need};
      // It may be another need by which the loser was found.
      const std::vector<GroupId> common = input.shared.indispensable().in_common(need.id, task->target);
      if (!common.empty()) return KeptOff{task, has(common, need.id) ? need.id : common.front(), &need};
    }
  }
  return std::nullopt;
}

} // namespace director::analysis
