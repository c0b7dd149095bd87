#pragma once
// SPDX-License-Identifier: MIT
// Finds what tasks certainly hold when others are tried, and what may prevent that.

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/input.hpp"
#include "compiler/analysis/plans/plans.hpp"
#include "compiler/analysis/states/region.hpp"

#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace director::analysis {

using Groups = std::vector<GroupId>; ///< sorted, each once

bool has(const Groups& groups, GroupId group);
Groups joined(const Groups& a, const Groups& b);
Groups in_common(const Groups& a, const Groups& b);

/// Entries that are granted together: the mandatory ones of a pack that are not `apart`, or one by itself.
using Unit = std::vector<const Task*>;

/// Why a group is held whenever a task is tried.
struct Taker {
  enum class Kind {
    above, ///< by `holder`, which is above the task: it is that group, or one that it needs
    unit,  ///< by `by`, a member of a unit that is granted together before anything below it is tried
    before ///< by `by`, which goes before and never has to wait
  };
  Kind kind = Kind::above;
  GroupId group{};            ///< what is held
  GroupId holder{};           ///< of `above`
  const Task* by = nullptr;   ///< of `unit` and `before`
  const Task* over = nullptr; ///< the entry beside `by`: the task's own, or one that leads to it
  const Unit* unit = nullptr; ///< in which `by` is granted; null for `above`
  Groups needers;             ///< of `above`: the groups whose need it is held for, so that their own request for it is
                              ///< granted
  /// What others may withhold from `by`. It makes no difference to a task that must have all of this too.
  Groups spoilers;
  /// Whether nothing ever takes it away, not even while a stale group above `by` is about to run.
  bool steady = true;
  const Task* leader = nullptr; ///< of `before`: the member of the unit that goes before `over`, often `by`

  /// The leader if it is another one than `by`; else null.
  const Task* led_by() const { return kind == Kind::before && leader != by ? leader : nullptr; }
};

/// What the members of a unit take, each with its needs.
struct UnitTakes {
  std::vector<Groups> always; ///< by each member, with every way to grant the unit
  /// The same if nothing else is held: then it never has to wait. Empty: it may.
  std::vector<Groups> at_first;
  std::vector<Groups> maybe; ///< by each member in one of these ways; empty as `at_first` is
  /// Groups that one member takes and another member's tasks may hold at equal rank, from a time when that member was
  /// requested without the first: equals take nothing from each other.
  Groups disputed;
};

class Takers {
public:
  explicit Takers(const Input& input);

  /// Whether several edges want it, so that one may take it from another.
  bool is_contested(GroupId group) const { return input_.model.groups[group].requesters.size() > 1; }

  /// What the provider takes with each of its plans: its own group, and what its needs lead to.
  const Groups& must(ProviderId provider);
  /// The same for a task, with any active provider.
  const Groups& must(GroupId group);
  /// What the group holds while one of these runs, or while it is held for a need afterwards.
  Groups held_by(GroupId group, const std::vector<ProviderId>& running);
  /// The same, whichever of its providers runs.
  const Groups& held_by(GroupId group);
  /// The groups whose need the group may be held for while `holder` runs.
  Groups needers(GroupId holder, GroupId group);

  /// What the unit takes if it is granted, by member.
  const UnitTakes& takes(GroupId requester, const Unit& unit);
  /// Whether no condition of it, or of its possible needs, ever changes its provider.
  bool is_unconditional(GroupId group);
  /// In the graph's order, requesters first.
  std::size_t place_of(GroupId group) const { return place_[group]; }
  /// Whether a requester that may run may request or need it by this edge.
  bool is_alive(EdgeId edge) const;

  /// With all levels at which the two are requested.
  bool always_before(const Task& first, const Task& second) const;
  /// Whether they have one rank, and the second one is never requested without the first or before it.
  bool always_first_of_equals(GroupId requester, const Task& first, const Task& second) const;
  /// Whether they are equal at all levels, and this requester requests the first whenever it requests the second.
  bool always_beside(GroupId requester, const Task& first, const Task& second) const;
  /// Whether it may continue for another requester, or without one until the next request.
  bool may_change_holder(GroupId group) const;
  /// Whether between two runs of others it may change its provider or its holder, or be requested again.
  bool may_become_stale(GroupId group) const;
  /// Whether tasks for the two may have equal priority at the point where their chains meet, or one leads to the other.
  bool may_be_equals(GroupId a, GroupId b);
  /// Whether another group's plan may hold the group, by any provider that can run.
  bool is_needed(GroupId group) const;
  bool is_mandatory(const Task& task) const;
  bool is_optional(const Task& task) const;
  bool is_apart(const Task& task) const;
  bool is_member(const Task& task) const; ///< of the unit of its pack
  /// Whether its members exclude each other, which another check reports.
  bool is_never_whole(const Pack& pack) const { return never_whole_.count(&pack) != 0; }

private:
  Groups find_disputed(GroupId requester, const Unit& unit) const;
  /// A region around all states in which a request of the group may exist.
  Region region_of_requests(GroupId requester) const;
  /// Whether one of the ways can be used in the whole region.
  bool covers(const Region& region, const std::vector<Region>& ways) const;

  const Input& input_;
  std::set<const Pack*> never_whole_;
  IdTable<GroupId, std::size_t> place_;
  IdTable<GroupId, std::optional<bool>> unconditional_;
  Indispensable parts_; ///< by providers that may run at all
  std::unordered_map<ProviderId, Groups> must_of_provider_;
  std::unordered_map<GroupId, Groups> must_of_group_;
  std::unordered_map<GroupId, Groups> held_by_group_;
  std::map<std::pair<GroupId, GroupId>, bool> may_be_equals_;
  std::map<std::pair<GroupId, const Task*>, UnitTakes> takes_; ///< by the unit's first entry
};

} // namespace director::analysis
