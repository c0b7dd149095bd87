#pragma once
// SPDX-License-Identifier: MIT
// Finds members of a pack that can never be granted together.

#include "compiler/analysis/input.hpp"
#include "compiler/analysis/needs/units.hpp"
#include "compiler/analysis/plans/plans.hpp"

#include <optional>
#include <vector>

namespace director::analysis {

/// A smallest set of members that exclude each other: two, or the whole unit.
struct PackConflict {
  ProviderId provider{};
  const Pack* pack = nullptr;
  std::vector<const Task*> members; ///< in the order written
  UnitVerdict verdict = UnitVerdict::impossible;
  std::vector<const Task*> others =
      {}; ///< of a long unit: what the first member excludes for the same reason as the second
  std::vector<GroupId> targets() const; ///< of the members
};

/// For every pack and flat list of every provider; in a flat list only pairs, since any part of it may be requested. In
/// long ones each member is in one conflict, with the first that it excludes.
std::vector<PackConflict> find_pack_conflicts(const Model& model, Units& units);

/// A member that never runs: by a need, the provider of another member holds a group that this member must have.
struct KeptOff {
  const Task* member = nullptr;
  GroupId group{};
  const Use<GroupId>* need = nullptr;
};
std::optional<KeptOff> find_kept_off(const Input& input, const PackConflict& conflict);

} // namespace director::analysis
