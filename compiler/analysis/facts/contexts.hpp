#pragma once
// SPDX-License-Identifier: MIT
// Finds the states with which a group is ever requested, and whether a provider can begin there: a task is tried only
// while its requester can run, and granted with all its needs, so the conditions of both hold at once; and so on
// upwards, except for groups in limbo.

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/states/region.hpp"

#include <functional>
#include <unordered_map>

namespace director::analysis {

class Contexts {
public:
  /// `facts` may grow; results for smaller ones remain valid.
  Contexts(const Model& model, Facts& facts);

  /// The regions in which a task is requested.
  struct Requested {
    Region tried;   ///< around all states with which it is
    Region granted; ///< ... with which it can be granted: with everything that is granted together with it
  };

  /// Records that it is requested there too; true: with more states than before.
  bool widen(GroupId group, const Requested& requested);
  /// Visits each group that its active providers request.
  void visit_below(GroupId group, const std::function<void(GroupId, const Requested&)>& visitor);

  /// Forgets the results for needs and members that depend on what can be pushed; true: there were some.
  bool forget_needed();
  /// Whether some choice for its needs may hold in this region.
  bool can_begin(ProviderId id, Region within);
  /// The same for a provider that may run already, for another requester.
  bool can_go_on(ProviderId id, Region within);

private:
  /// Whether limbo may keep the group while its requester cannot run (semantics.md 4.4, "Limbo"), because a stale group
  /// may still request that requester.
  bool may_be_in_limbo(GroupId group) const;
  /// Around the states with which it runs, pushed or not.
  Region around(ProviderId id) const;
  /// ... for a request.
  Region around_requested(ProviderId id);
  /// Around all states that may follow one in the region, itself included.
  Region after(const Region& region) const;
  /// Around the region and those of the states after it that are within the first one: where what began in the region
  /// may be kept.
  Region kept_within(const Region& within, const Region& region) const;
  /// Whether the task is granted only together with others of the pack, at each of its levels.
  bool is_always_member(const Pack& pack, const Task& task) const;
  /// Around the states with which all of these can run.
  const Region& around_members(const Pack& pack);
  const Region& around_needed(GroupId group);
  bool may_be(const Region& region) const;
  bool always_has_needs(const compiler::Provider& provider) const;
  bool has_choice(ProviderId id, Region within);

  friend class JointPlan;
  const Model& model_;
  Facts& facts_;
  std::unordered_map<GroupId, Region> needed_; ///< where some choice for the group holds, in any context
  std::unordered_map<const Pack*, Region> members_;
};

} // namespace director::analysis
