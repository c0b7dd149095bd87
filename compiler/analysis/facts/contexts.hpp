#pragma once
// SPDX-License-Identifier: MIT
// Under which states a group is ever asked for, and whether a provider can begin there: a task is tried only while its
// requester can run, and granted with all that it needs, so the conditions of both hold at once; and so on upwards as
// far as nothing is kept for an heir.

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/states/region.hpp"

#include <functional>
#include <optional>
#include <unordered_map>

namespace director::analysis {

class Contexts {
public:
  /// `facts` may grow; what is found for smaller ones stays true.
  Contexts(const Model& model, Facts& facts);

  /// Where a task is asked for.
  struct Requested {
    Region tried;   ///< around all states in which it is
    Region granted; ///< ... in which it can be: with all that is granted with it, or not at all
  };

  /// It is requested there too; true: in more states than before.
  bool widen(GroupId group, const Requested& requested);
  /// For each group that its active providers ask for.
  void visit_below(GroupId group, const std::function<void(GroupId, const Requested&)>& visitor);

  /// What was found of needs and members before more could be pushed; true: there was something.
  bool forget_needed();
  /// Around the states in which it can begin: its `when`, leaving out what is reported as impossible.
  Region own(ProviderId id) const;
  /// Some choice for its needs may hold in this region.
  bool can_begin(ProviderId id, Region within);
  /// The same for one that may run already, for somebody else.
  bool can_go_on(ProviderId id, Region within);

private:
  /// It may run on for a requester that cannot any more and is kept for an heir (semantics.md 4.4, "Hand-over"): one
  /// that some group asks for, or needs.
  bool is_kept_adrift(GroupId group) const;
  Region around(ProviderId id, bool pushed) const;
  /// Where it runs for a request.
  Region around_requested(ProviderId id);
  /// Around all states that may follow one in the region, itself included.
  Region after(const Region& region) const;
  /// The task is granted with others of the pack or not at all, whatever its level.
  bool is_always_member(const Pack& pack, const Task& task) const;
  /// Around the states in which all of these can run.
  const Region& around_members(const Pack& pack);
  const Region& around_needed(GroupId group);
  bool may_be(const Region& region) const;
  bool always_has_needs(const compiler::Provider& provider) const;
  bool has_choice(ProviderId id, Region within);

  friend class JointPlan;
  const Model& model_;
  Facts& facts_;
  std::unordered_map<GroupId, Region> needed_; ///< where some choice for the group holds, whatever is known
  std::unordered_map<const Pack*, Region> members_;
};

} // namespace director::analysis
