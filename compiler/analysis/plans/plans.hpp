#pragma once
// SPDX-License-Identifier: MIT
// The plans of a provider's needs (semantics.md, section 1): for each needed group a provider of it, and what that one
// needs, no group twice. Whether there is one is NP-complete (it is exact cover in disguise), so the search counts its
// steps.

#include "compiler/analysis/effort/budget.hpp"
#include "compiler/model/model.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace director::analysis {

using namespace director::compiler;

/// More steps than any behaviour of people took by a factor of a thousand; a fraction of a second.
inline constexpr std::int64_t plan_steps = 1'000'000;

struct PlanCount {
  std::int64_t plans = 0; ///< exact where `complete`, else at least so many
  bool complete = true;   ///< the search came to its end within its steps, below `most`
};

/// The valid plans of a provider, up to `most` of them. A provider without needs has one.
PlanCount count_plans(const Model& model, ProviderId provider, std::int64_t most, Budget& budget);

enum class PlanVerdict { found, none, undecided };
/// `mended`: providers that are taken to need nothing.
PlanVerdict find_plan(const Model& model, ProviderId provider, Budget& budget,
                      const IdSet<ProviderId>* mended = nullptr);

/// Groups that are part of every way to have a group, itself included: what two needs cannot both come down to.
/// Cycles are no way to have a group.
class Indispensable {
public:
  /// `counts`: only these providers are ways; nothing: all.
  explicit Indispensable(const Model& model, const IdSet<ProviderId>* counts = nullptr);
  /// `part` is of every way to have `group`. Anything is, if there is no way.
  bool contains(GroupId group, GroupId part) const;
  /// In order; nothing: there is no way.
  const std::optional<std::vector<GroupId>>& of(GroupId group) const { return parts_[group]; }
  /// What two groups both cannot do without, in order; none where there is no way to have one of them.
  std::vector<GroupId> in_common(GroupId a, GroupId b) const;

private:
  IdTable<GroupId, std::optional<std::vector<GroupId>>> parts_;
};

} // namespace director::analysis
