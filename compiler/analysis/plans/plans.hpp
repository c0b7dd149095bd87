#pragma once
// SPDX-License-Identifier: MIT
// Finds the plans of a provider's needs (semantics.md, section 1): for each needed group a provider of it, and the
// needs of that one, no group twice. Deciding whether there is one is NP-complete (by exact cover), so the search
// counts its steps.

#include "compiler/analysis/effort/budget.hpp"
#include "compiler/model/model.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace director::analysis {

using namespace director::compiler;

/// A thousand times the steps of any real behaviour; a fraction of a second.
inline constexpr std::int64_t plan_steps = 1'000'000;

/// Exact if `complete`, else lower bounds.
struct PlanCount {
  std::int64_t plans = 0;
  std::int64_t dead_ends =
      0;                ///< beginnings of plans that the engine tries too: the next need is a group that they hold
  bool complete = true; ///< the search ended within its steps, below `most`
  std::int64_t tried() const { return plans + dead_ends; }
};

/// The valid plans of a provider, up to `most` that are tried. A provider without needs has one.
PlanCount count_plans(const Model& model, ProviderId provider, std::int64_t most, Budget& budget);

enum class PlanVerdict { found, none, undecided };
/// `mended`: providers that are assumed to need nothing.
PlanVerdict find_plan(const Model& model, ProviderId provider, Budget& budget,
                      const IdSet<ProviderId>* mended = nullptr);

/// Groups that are part of every way to grant a group, itself included: two needs cannot both lead to such a group. A
/// cycle is no way to grant a group.
class Indispensable {
public:
  /// `counts`: only these providers count; null: all.
  explicit Indispensable(const Model& model, const IdSet<ProviderId>* counts = nullptr);
  /// Whether `part` is in every way to grant `group`. Any group is, if there is no way.
  bool contains(GroupId group, GroupId part) const;
  /// Whether it is in every way to grant one of the provider's needs.
  bool needs_contain(const compiler::Provider& provider, GroupId part) const;
  /// Whether the provider's needs contain something that is in every way to grant the group; not if there is no way.
  bool needs_part_of(const compiler::Provider& provider, GroupId group) const;
  /// In order; empty optional: there is no way.
  const std::optional<std::vector<GroupId>>& of(GroupId group) const { return parts_[group]; }
  /// The groups that are indispensable for both, in order; none if one of them cannot be granted.
  std::vector<GroupId> in_common(GroupId a, GroupId b) const;

private:
  IdTable<GroupId, std::optional<std::vector<GroupId>>> parts_;
};

} // namespace director::analysis
