#pragma once
// SPDX-License-Identifier: MIT
// Decides whether the members of a unit can be granted together (semantics.md, 4.4): a provider and a plan for each, no
// group twice, and conditions that can hold at the same time. This is NP-complete, like plans, so the search counts its
// steps.

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/states/region.hpp"

#include <functional>
#include <unordered_map>
#include <vector>

namespace director::analysis {

/// The tasks that are granted together in this pack: those that share its unit.
std::vector<const Task*> unit_members(const Model& model, const Pack& pack);

/// A choice for every member and for all their needs.
struct Combination {
  struct Pick {
    GroupId group{};
    ProviderId provider{};
  };
  std::vector<Pick> picks; ///< each member before its needs
  Region region;           ///< where their conditions hold
};

enum class UnitVerdict { possible, impossible, undecided };

class Units {
public:
  /// A thousand times the steps of any real pack.
  static constexpr std::int64_t most_steps = 200'000;

  Units(const Model& model, const Facts& facts, Budget& budget) : model_(model), facts_(facts), budget_(budget) {}

  /// Whether all of these can be granted at once. Fast if they share no need and no state. `by_groups_alone`: ignoring
  /// conditions.
  UnitVerdict verdict(const std::vector<GroupId>& members, bool by_groups_alone = false);

  /// Visits every combination, in the order in which they are tried, until the visitor returns false. False: there are
  /// more than the limit. `by_groups_alone`: also those whose conditions exclude each other.
  bool visit(const std::vector<GroupId>& members, bool by_groups_alone,
             const std::function<bool(const Combination&)>& visitor);

  /// The group, its possible needs, and theirs; sorted.
  const std::vector<GroupId>& needed(GroupId group);

  /// Where some choice for the group may run, with its needs.
  Region region_at_best(GroupId group);

private:
  bool may_clash(const std::vector<GroupId>& members);

  const Model& model_;
  const Facts& facts_;
  Budget& budget_;
  std::unordered_map<GroupId, std::vector<GroupId>> needed_;
  std::unordered_map<GroupId, Region> regions_;
};

} // namespace director::analysis
