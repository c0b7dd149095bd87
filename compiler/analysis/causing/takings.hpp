#pragma once
// SPDX-License-Identifier: MIT
// Finds what a task takes from the providers of other groups when it is granted.

#include "compiler/analysis/causing/wants.hpp"
#include "compiler/analysis/chains/claims.hpp"
#include "compiler/analysis/plans/plans.hpp"
#include "dsl/source/diagnostic.hpp"

#include <optional>
#include <vector>

namespace director::analysis {

/// How something is lost, and the requests below the task on that chain: what they request ends with the task.
struct Taking {
  std::vector<dsl::Note> notes;
  std::vector<dsl::Span> requests;
};

/// Adds to a finding, that the condition becomes false because of what the granted task takes, where this happens.
/// `source`: what makes the condition true.
void add_taking(const Model& model, const Want& want, dsl::Note source, Taking how, dsl::Diagnostic& finding);

class Takings {
public:
  /// From everything, whatever goes first. `claims`: those of the task; must outlive this.
  Takings(const Model& model, const Indispensable& indispensable, const Claims& claims, GroupId task)
      : model_(model),
        indispensable_(indispensable),
        claims_(claims),
        task_(task),
        unit_(task) {}
  /// Only from what it may go before. `unit`: a task that is granted together with it, or the same. `is_held`: its
  /// requester needs it, so that it and its needs were taken before.
  Takings(const Model& model, const Indispensable& indispensable, const Claims& claims, GroupId task, GroupId unit,
          bool is_held, const Chains& ranks)
      : model_(model),
        indispensable_(indispensable),
        claims_(claims),
        task_(task),
        unit_(unit),
        is_held_(is_held),
        ranks_(&ranks) {}

  /// Whether the task, or one below it, may hold the group itself.
  bool takes(GroupId group) const { return takes_from(group, group); }
  /// The provider's needs that lead to a group which is certainly taken.
  std::vector<const Use<GroupId>*> needs_taken(ProviderId id) const;
  /// The first of them; null: there is none.
  const Use<GroupId>* need_taken(ProviderId id) const;
  /// Whether the task, or the one that is granted together with it, may go before the group.
  bool may_beat(GroupId group) const;
  /// How a provider of this group loses that need.
  Taking way_to(const Use<GroupId>& need, GroupId of) const;
  /// How the group itself is taken.
  Taking way_to(GroupId group) const { return way_to({group, {}}, group); }

private:
  bool takes_from(GroupId loser, GroupId group) const { return find_taking(loser, group).has_value(); }
  std::optional<Reach> find_taking(GroupId loser, GroupId group) const;
  bool goes_before(Reach reach, GroupId loser) const;
  std::optional<GroupId> part_taken(GroupId loser, GroupId needed) const;

  const Model& model_;
  const Indispensable& indispensable_;
  const Claims& claims_;
  GroupId task_;
  GroupId unit_;
  bool is_held_ = false;
  const Chains* ranks_ = nullptr;
};

} // namespace director::analysis
