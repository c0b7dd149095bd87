// Header: compiler/analysis/conflicts/packmates.hpp. Test: compiler/checks/starved_task.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/packmates.hpp"

#include "compiler/analysis/chains/sparse_set.hpp"
#include "compiler/analysis/shared/shared.hpp"

#include <algorithm>

namespace director::analysis {

namespace {

/// Limit for the entries that may take one group and are considered for one entry; those of the highest rank come
/// first.
constexpr std::size_t most_others = 8;
/// Limit for the groups that may request one group and are examined; with more, one of them is assumed to request it.
constexpr std::size_t most_requesters = 200;

bool is_in(const Unit& unit, const Task* task) { return std::find(unit.begin(), unit.end(), task) != unit.end(); }

} // namespace

const std::vector<PackEntry>& Packmates::of(const Provider& provider, const Pack& pack) {
  const auto [at, is_new] = entries_.try_emplace(&pack);
  std::vector<PackEntry>& out = at->second;
  if (!is_new) return out;
  // The members that a request for all of a list has in one unit: its mandatory entries; `apart` ones each by itself.
  const Unit& unit = units_.emplace_back(provider.has_packs ? unit_members(input_.model, pack) : Unit{});
  Unit& company = units_.emplace_back();
  for (const Task& task : pack.tasks) {
    if (input_.model.may_be_member(task)) company.push_back(&task);
  }
  ByTaken by_taken;
  if (provider.has_packs && pack.tasks.size() > 1) {
    // At other levels more entries may be members, and then it waits for them.
    const bool is_all = std::all_of(pack.tasks.begin(), pack.tasks.end(), [&](const Task& task) {
      return is_in(unit, &task) || takers_.is_optional(task) || (takers_.is_mandatory(task) && takers_.is_apart(task));
    });
    if (!unit.empty() && !takers_.is_never_whole(pack)) add_rivals(provider.group, unit, is_all, by_taken);
    for (const Task& task : pack.tasks) {
      if (takers_.is_mandatory(task) && takers_.is_apart(task))
        add_rivals(provider.group, units_.emplace_back(Unit{&task}), true, by_taken);
    }
  }
  const auto rank = [&](const Rival& rival) {
    return input_.model.edges[rival.task->edge].levels[rival.task->levels[0].level].priority;
  };
  for (auto& [group, rivals] : by_taken)
    std::stable_sort(rivals.begin(), rivals.end(), [&](const Rival& a, const Rival& b) { return rank(a) > rank(b); });
  for (const Task& task : pack.tasks) {
    PackEntry entry{&task, is_in(unit, &task) ? &unit : nullptr, {}, is_in(company, &task) ? &company : nullptr};
    if (!by_taken.empty()) add_mates(provider.group, by_taken, entry);
    out.push_back(std::move(entry));
  }
  return out;
}

void Packmates::add_rivals(GroupId requester, const Unit& unit, bool is_all, ByTaken& to) {
  const UnitTakes& takes = takers_.takes(requester, unit);
  const bool at_first = is_all && !takes.at_first.empty();
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const Groups& groups = at_first ? takes.at_first[i] : takes.always[i]; // the larger set
    for (const GroupId group : groups) {
      if (takers_.is_contested(group)) to[group].push_back({unit[i], &unit, has(takes.always[i], group), at_first});
    }
  }
}

void Packmates::add_mates(GroupId requester, const ByTaken& by_taken, PackEntry& entry) {
  const Groups& wanted = input_.shared.claims(entry.task->target).groups();
  for (const auto& [group, rivals] : by_taken) {
    if (!has(wanted, group)) continue;
    std::size_t tried = 0;
    for (const Rival& rival : rivals) {
      if (rival.task == entry.task) continue;
      if (++tried > most_others) break;
      auto mate = find_mate(requester, rival, group, entry);
      if (!mate) continue;
      const bool is_enough = mate->taker.steady && mate->from_below && (mate->from_entry || entry.unit != nullptr);
      entry.mates.push_back(std::move(*mate));
      if (is_enough) break;
    }
  }
}

std::optional<Packmate> Packmates::find_mate(GroupId requester, const Rival& rival, GroupId group,
                                             const PackEntry& entry) {
  const Task &by = *rival.task, &over = *entry.task;
  const bool before = takers_.always_before(by, over);
  const bool first = is_first(requester, by, over);
  const bool together = beside(requester, *rival.unit, by, over).is_before_below;
  Packmate out{{before ? Taker::Kind::before : Taker::Kind::unit, group, {}, &by, &over, rival.unit, {}, {}, true},
               rival.unit,
               false,
               true};
  if (is_in(*rival.unit, &over)) {
    if (!rival.always) return std::nullopt;
    out.taker.steady =
        takers_.is_unconditional(by.target) && takers_.takes(requester, *rival.unit).disputed.empty() &&
        spoilers(beside(requester, *rival.unit, by, over)).of(input_.shared.units().needed(by.target)).empty();
    if (!out.taker.steady) out.taker.kind = Taker::Kind::unit; // then the others wait with it
    return out;
  }
  out.from_below = first || together;
  out.taker.leader = find_leader(requester, rival, entry);
  out.from_entry = out.taker.leader != nullptr;
  if (!rival.at_first || (!first && !together && !takers_.is_mandatory(over))) return std::nullopt;
  // It waits until the task that goes before it has run, and then for its requester if that is stale by then: meanwhile
  // what the first one requested may be granted.
  if (!out.from_below && takers_.may_become_stale(requester)) return std::nullopt;
  out.taker.kind = Taker::Kind::before;
  out.taker.spoilers = spoilers_of(requester, rival, over);
  if (!before && !out.taker.spoilers.empty() && may_keep(requester, *rival.unit, over)) return std::nullopt;
  out.taker.steady = out.taker.spoilers.empty() && takers_.is_unconditional(by.target);
  return out;
}

/// The member at whose place the unit is tried, if that is always before the unit of the entry: rather `by` itself.
const Task* Packmates::find_leader(GroupId requester, const Rival& rival, const PackEntry& entry) const {
  const auto goes_first = [&](const Task& member) {
    // A group may ask for what `by` takes while it goes before that, and not before the entry. If the entry goes before
    // `by`, only a member that goes before the entry by rank excludes this.
    const bool is_like_by =
        is_first(requester, *rival.task, *entry.task) || takers_.always_beside(requester, *rival.task, *entry.task);
    const auto before = [&](const Task& other) {
      return is_like_by ? is_first(requester, member, other) : takers_.always_before(member, other);
    };
    return before(*entry.task) &&
           (entry.company == nullptr ||
            std::all_of(entry.company->begin(), entry.company->end(), [&](const Task* each) { return before(*each); }));
  };
  if (goes_first(*rival.task)) return rival.task;
  const auto at =
      std::find_if(rival.unit->begin(), rival.unit->end(), [&](const Task* member) { return goes_first(*member); });
  return at == rival.unit->end() ? nullptr : *at;
}

bool Packmates::is_first(GroupId requester, const Task& by, const Task& over) const {
  return takers_.always_before(by, over) || takers_.always_first_of_equals(requester, by, over);
}

Beside Packmates::beside(GroupId requester, const Unit& unit, const Task& by, const Task& over) const {
  // Of two equals that are requested together both are granted before anything below one of them is tried. Not during a
  // hand-over of the requester: then nothing is held for it, and the one that was requested first goes first with
  // everything below it.
  const bool is_before_below = !is_first(requester, by, over) && by.edge != over.edge &&
                               takers_.always_beside(requester, by, over) && !takers_.may_change_holder(requester);
  return {requester, &unit, &by, &over, is_before_below};
}

/// What others may withhold from any member of the unit: then all its members wait.
Groups Packmates::spoilers_of(GroupId requester, const Rival& rival, const Task& over) {
  const UnitTakes& takes = takers_.takes(requester, *rival.unit);
  Groups out;
  for (std::size_t i = 0; i < rival.unit->size(); ++i) {
    const Groups& taken = takes.maybe[i];
    out = joined(out, joined(spoilers(beside(requester, *rival.unit, *(*rival.unit)[i], over)).of(taken),
                             in_common(taken, takes.disputed)));
  }
  return out;
}

const Spoilers& Packmates::spoilers(const Beside& beside) {
  const bool differs = !is_in(*beside.unit, beside.over) &&
                       (!takers_.always_before(*beside.by, *beside.over) || takers_.is_member(*beside.over));
  std::unique_ptr<Spoilers>& out = spoilers_[{beside.by, differs ? beside.over : nullptr}];
  if (!out) out = std::make_unique<Spoilers>(input_, takers_, beside);
  return *out;
}

/// Whether tasks of an equal entry may hold something that the unit takes, from a time when others withheld that from
/// the unit: equals take nothing from each other.
bool Packmates::may_keep(GroupId requester, const Unit& unit, const Task& over) {
  const Claims& claims = input_.shared.claims(over.target);
  const std::vector<Groups>& taken = takers_.takes(requester, unit).maybe;
  return std::any_of(taken.begin(), taken.end(), [&](const Groups& groups) {
    return std::any_of(groups.begin(), groups.end(),
                       [&](GroupId group) { return claims.find(group, Reach::mandatory) != nullptr; });
  });
}

bool Packmates::may_be_deferred(GroupId requester, const Unit& unit) {
  const auto [at, is_new] = may_be_deferred_.try_emplace(&unit, false);
  if (!is_new) return at->second;
  const UnitTakes& takes = takers_.takes(requester, unit);
  for (std::size_t i = 0; i < unit.size() && !at->second; ++i) {
    const Groups& taken = takes.maybe.empty() ? input_.shared.units().needed(unit[i]->target) : takes.maybe[i];
    at->second = std::any_of(taken.begin(), taken.end(),
                             [&](GroupId group) { return may_be_requested_above(requester, *unit[i], group); });
  }
  return at->second;
}

/// By a group that goes before the member, does not hold that group already as a need, and is not always above.
bool Packmates::may_be_requested_above(GroupId requester, const Task& member, GroupId group) {
  const Chains& chains = input_.shared.chains();
  Groups requesting{group};
  SparseSet<GroupId> seen;
  seen.add(group);
  for (std::size_t next = 0; next < requesting.size(); ++next) {
    for (const EdgeId id : input_.model.groups[requesting[next]].requesters) {
      const std::optional<GroupId> by = input_.model.edges[id].requester;
      if (by && takers_.is_alive(id) && seen.add(*by)) requesting.push_back(*by);
    }
    if (requesting.size() > most_requesters) return true;
  }
  return std::any_of(requesting.begin() + 1, requesting.end(), [&](GroupId each) {
    if (each == requester || chains.always_below(requester, each) || has(takers_.must(each), group)) return false;
    bool goes_before = false;
    chains.visit(each, {member.target, requester}, [&](const Meeting& meeting, GroupId other) {
      // Nothing of its own unit is granted when that is tried.
      const bool is_ours = other == requester || (meeting.second->edge == member.edge && !meeting.one_unit());
      goes_before = goes_before || (is_ours && meeting.first_goes_before());
    });
    return goes_before;
  });
}

} // namespace director::analysis
