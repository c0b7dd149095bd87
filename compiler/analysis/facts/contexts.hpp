#pragma once
// SPDX-License-Identifier: MIT
// Under which states a group is ever asked for, and whether a provider can begin there: a task is tried only while its
// requester can run, and granted with all that it needs, so the conditions of both hold at once; and so on upwards as
// far as nothing is kept for an heir.

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/states/region.hpp"

#include <optional>
#include <unordered_map>

namespace director::analysis {

class Contexts {
public:
  /// `facts` may grow; what is found for smaller ones stays true.
  Contexts(const Model& model, Facts& facts);

  /// It is requested, in this region too; true: in more states than before.
  bool widen(GroupId group, const Region& region);
  /// Around all states in which what the group's active providers ask for is tried; nothing: it has none.
  std::optional<Region> below(GroupId group);

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
  const Region& around_needed(GroupId group);
  bool may_be(const Region& region) const;
  bool always_has_needs(const compiler::Provider& provider) const;
  bool has_choice(ProviderId id, Region within);

  friend class JointPlan;
  const Model& model_;
  Facts& facts_;
  std::unordered_map<GroupId, Region> needed_; ///< where some choice for the group holds, whatever is known
};

} // namespace director::analysis
