#pragma once
// SPDX-License-Identifier: MIT
// What a task takes from the providers of other groups when it is granted.

#include "compiler/analysis/causing/wants.hpp"
#include "compiler/analysis/chains/claims.hpp"
#include "compiler/analysis/plans/plans.hpp"
#include "dsl/diagnostic.hpp"

#include <optional>
#include <vector>

namespace director::analysis {

/// How it comes to a loss, and the requests below the task on the way: what they ask for goes with the task.
struct Taking {
  std::vector<dsl::Note> notes;
  std::vector<dsl::Span> requests;
};

/// Of a finding that what a granted task takes makes its condition false again: where that is seen.
void add_taking(const Model& model, const Want& want, ProviderId causer, Taking how, dsl::Diagnostic& finding);

class Takings {
public:
  /// `claims`: those of the task, which is there as long as this is.
  Takings(const Model& model, const Indispensable& indispensable, const Claims& claims, GroupId task)
      : model_(model),
        indispensable_(indispensable),
        claims_(claims),
        task_(task) {}

  /// The task, or one below it, may hold the group itself.
  bool takes(GroupId group) const { return claims_.contains(group); }
  /// The provider's first need that comes down to something taken in any case.
  const Use<GroupId>* need_taken(ProviderId id) const;
  /// How that need is lost.
  Taking way_to(const Use<GroupId>& need) const;

private:
  std::optional<GroupId> part_taken(GroupId needed) const;

  const Model& model_;
  const Indispensable& indispensable_;
  const Claims& claims_;
  GroupId task_;
};

} // namespace director::analysis
