#pragma once
// SPDX-License-Identifier: MIT
// What tasks are certain to hold when others are tried, and what may keep them from it.

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
    unit,  ///< by `by`, a member of a unit that is granted whole before anything below it is tried
    before ///< by `by`, which goes before and never has to wait
  };
  Kind kind = Kind::above;
  GroupId group{};            ///< what is held
  GroupId holder{};           ///< of `above`
  const Task* by = nullptr;   ///< of `unit` and `before`
  const Task* over = nullptr; ///< the entry beside `by`: the task's own, or one that leads to it
  Groups needers;             ///< of `above`: by whose need it is held, so that their own request for it is met
  /// What others may keep from `by`. Only to a task that must have all of this too it makes no difference.
  Groups spoilers;
  /// Nothing ever takes it away, not even for the moment until somebody above `by`, who has new orders, has run.
  bool steady = true;
};

/// What the members of a unit take, each with what it needs.
struct UnitTakes {
  std::vector<Groups> always; ///< by each member, however the unit is granted
  /// The same where nobody else holds anything: then it never has to wait. Nothing: it may.
  std::vector<Groups> at_first;
  Groups maybe; ///< all of them together, in these ways
  /// What one member takes and another one's tasks may hold, with equal rank, from a time when that one was asked for
  /// without the first: equals take nothing from each other.
  Groups disputed;
};

class Takers {
public:
  explicit Takers(const Input& input);

  /// Several want it, so that one may take it from another.
  bool is_contested(GroupId group) const { return input_.model.groups[group].requesters.size() > 1; }

  /// What the provider takes whichever plan it has: its own group, and what its needs come down to.
  const Groups& must(ProviderId provider);
  /// The same for a task, whichever provider that may be active runs for it.
  const Groups& must(GroupId group);
  /// What the group holds while one of these runs, or while it is held for a need after that.
  Groups held_by(GroupId group, const std::vector<ProviderId>& running);
  /// The same, whichever of its providers runs.
  const Groups& held_by(GroupId group);
  /// By whose need the group may be held while `holder` runs.
  Groups needers(GroupId holder, GroupId group);

  /// What the unit takes where it is granted, by its members.
  const UnitTakes& takes(GroupId requester, const Unit& unit);
  /// No condition of it, or of what it may need, ever makes it change its provider.
  bool is_unconditional(GroupId group);
  /// In the graph's order, requesters first.
  std::size_t place_of(GroupId group) const { return place_[group]; }
  /// Somebody who may run may request or need it by this edge.
  bool is_alive(EdgeId edge) const;

  /// At whichever levels the two are requested.
  bool always_before(const Task& first, const Task& second) const;
  /// They have one rank, and the second one is never asked for without the first or before it.
  bool always_first_of_equals(GroupId requester, const Task& first, const Task& second) const;
  /// They are equal at all levels, and whenever this requester asks for the second it asks for the first.
  bool always_beside(GroupId requester, const Task& first, const Task& second) const;
  /// It may run on for somebody else, or for nobody until the next one has asked for it.
  bool may_change_hands(GroupId group) const;
  /// Between two runs of others: it changes its provider or its holder, or is requested anew.
  bool may_get_new_orders(GroupId group) const;
  /// Tasks for the two may have one priority where their chains meet, or one leads to the other.
  bool may_be_equals(GroupId a, GroupId b);
  /// A plan of somebody else may hold the group, by any provider that can run.
  bool is_needed(GroupId group) const;
  bool is_mandatory(const Task& task) const;
  bool is_optional(const Task& task) const;
  bool is_apart(const Task& task) const;
  bool is_member(const Task& task) const; ///< of the unit of its pack
  /// Its members exclude each other: that is a finding of its own.
  bool is_never_whole(const Pack& pack) const { return never_whole_.count(&pack) != 0; }

private:
  Groups find_disputed(GroupId requester, const Unit& unit) const;
  /// Around all states in which something that the group requested may stand.
  Region region_of_requests(GroupId requester) const;
  /// Wherever the region holds one of the ways is open.
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
