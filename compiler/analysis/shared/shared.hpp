#pragma once
// SPDX-License-Identifier: MIT
// Results that several checks use, computed on first use and kept for the run.

#include "compiler/analysis/causing/imprecise.hpp"
#include "compiler/analysis/causing/promises.hpp"
#include "compiler/analysis/causing/wants.hpp"
#include "compiler/analysis/chains/claims.hpp"
#include "compiler/analysis/chains/meetings.hpp"
#include "compiler/analysis/decisions/decisions.hpp"
#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/facts/push_exclusion.hpp"
#include "compiler/analysis/needs/units.hpp"
#include "compiler/analysis/plans/plans.hpp"
#include "compiler/analysis/requests/requests.hpp"
#include "compiler/analysis/requests/standstill.hpp"
#include "compiler/analysis/states/choice.hpp"

#include <map>
#include <optional>
#include <utility>

namespace director::analysis {

class Shared {
public:
  Shared(const Model& model, const Graph& graph, const Facts& facts)
      : model_(model),
        graph_(graph),
        facts_(facts),
        budget_(facts.budget) {}
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;

  /// For all searches of this run.
  Budget& budget() const { return budget_; }
  /// Over the providers that may be active.
  const Chains& chains() const;
  const Promises& promises() const;
  /// With what is reported as impossible treated as corrected.
  const Decisions& decisions() const;
  const Requests& requests() const;
  const Causers& causers() const;
  const PushExclusion& push_exclusion() const;
  const std::vector<Imprecise>& imprecise() const;
  const std::vector<Wanting>& wants() const;
  const std::vector<Wanting>& wants_of_pushed() const;
  /// Of a task for this group, with any provider.
  std::vector<const Want*> wants_of(GroupId task) const;
  const Indispensable& indispensable() const;
  const Rivals& rivals() const;
  Units& units() const;
  Standstill& standstill() const;
  /// Of the providers that may be active.
  const Branches& branches() const;
  /// What a task for this group may come to hold, by providers that may be active.
  const Claims& claims(GroupId task) const;
  /// The same while `requester` runs: nothing leads through that again.
  const Claims& claims(GroupId task, GroupId requester) const;

private:
  bool is_active(ProviderId id) const { return facts_.active.contains(id); }

  const Model& model_;
  const Graph& graph_;
  const Facts& facts_;
  mutable Budget budget_;
  mutable std::optional<Chains> chains_;
  mutable std::optional<Promises> promises_;
  mutable std::optional<Decisions> decisions_;
  mutable std::optional<Requests> requests_;
  mutable std::optional<Causers> causers_;
  mutable std::optional<PushExclusion> push_exclusion_;
  mutable std::optional<std::vector<Imprecise>> imprecise_;
  mutable std::optional<std::vector<Wanting>> wants_;
  mutable std::optional<std::vector<Wanting>> wants_of_pushed_;
  mutable std::optional<Indispensable> indispensable_;
  mutable std::optional<Rivals> rivals_;
  mutable std::optional<Units> units_;
  mutable std::optional<Standstill> standstill_;
  mutable std::optional<Branches> branches_;
  mutable std::optional<ClaimsCache> claims_;
  mutable std::map<std::pair<GroupId, GroupId>, Claims> claims_without_;
};

} // namespace director::analysis
