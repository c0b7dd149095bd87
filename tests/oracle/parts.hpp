#pragma once
// SPDX-License-Identifier: MIT
// semantics.md, section 1, on the Model: the static part, written out in full. Need plans are enumerated, reachable
// groups are sets. Slow on purpose, like the whole folder, which shares no code with compiler/lower or runtime.

#include "compiler/model/model.hpp"

#include <set>
#include <string>
#include <vector>

namespace director::oracle {

using compiler::ConditionId;
using compiler::EdgeId;
using compiler::GroupId;
using compiler::IdTable;
using compiler::Level;
using compiler::Microseconds;
using compiler::Model;
using compiler::ProviderId;
using compiler::StateId;
using compiler::TriggerId;

/// Group `group` runs `provider`; `needer` needs it, by the edge needer -> group.
struct PlanEntry {
  GroupId group{};
  ProviderId provider{};
  GroupId needer{};
  EdgeId by{};
  bool operator==(const PlanEntry&) const = default;
};

/// Depth first: a group is right behind the one that needs it and what that one needs before it.
using Plan = std::vector<PlanEntry>;

class Parts {
public:
  explicit Parts(const Model& model);

  const Model& model() const { return model_; }
  GroupId group_of(ProviderId provider) const { return model_.providers[provider].group; }

  /// All valid plans for the needs of a provider, in order; one empty plan if it needs nothing.
  const std::vector<Plan>& plans(ProviderId provider) const { return plans_[provider]; }

  /// Declared tasks and needs, transitively.
  bool may_ask_for(GroupId from, GroupId target) const { return reach_[from].contains(target); }

  bool satisfies(ConditionId causing, ConditionId when) const;
  bool causes(ProviderId provider, ConditionId when) const; ///< whether a `causing` of it serves the condition
  bool causes_state(ProviderId provider, StateId state) const;

  // 4.1 puts limbo behind every declared edge. It has an edge of root for each group, behind all that are declared.
  EdgeId limbo(GroupId group) const;
  bool is_limbo(EdgeId edge) const { return edge.value >= model_.edges.size(); }
  std::optional<GroupId> requester(EdgeId edge) const; ///< nothing: root
  GroupId target(EdgeId edge) const;
  std::string name(EdgeId edge) const;

private:
  const Model& model_;
  IdTable<ProviderId, std::vector<Plan>> plans_;
  IdTable<GroupId, std::set<GroupId>> reach_;
};

} // namespace director::oracle
