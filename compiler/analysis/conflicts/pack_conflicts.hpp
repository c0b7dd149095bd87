#pragma once
// SPDX-License-Identifier: MIT
// Members of a pack that can never be granted together, and why.

#include "compiler/analysis/findings.hpp"
#include "compiler/analysis/input.hpp"
#include "compiler/analysis/needs/units.hpp"
#include "compiler/analysis/plans/plans.hpp"

#include <optional>
#include <vector>

namespace director::analysis {

/// The fewest members that exclude each other: two, or the whole unit.
struct PackConflict {
  ProviderId provider{};
  const Pack* pack = nullptr;
  std::vector<const Task*> members; ///< in the order written
  UnitVerdict verdict = UnitVerdict::impossible;
  std::vector<const Task*> others =
      {}; ///< of a long unit: what the first member excludes for the same reason as the second
};

/// Of every pack and flat list of every provider; of a flat list only pairs, since nobody says that all is asked for.
/// Of long ones each member stands in one, with the first that it excludes.
std::vector<PackConflict> find_pack_conflicts(const Model& model, Units& units);

/// A member that never runs, in whatever company: its provider holds by a need, for another member, what it must have.
struct KeptOff {
  const Task* member = nullptr;
  GroupId group{};
  const Use<GroupId>* need = nullptr;
};
std::optional<KeptOff> find_kept_off(const Input& input, const PackConflict& conflict);

/// Says what excludes what, to the bottom, at the last member: of packs with names, or of flat lists.
void report_pack_conflicts(const Input& input, bool of_packs, Findings& findings);

/// "`A` and `B`".
std::string members_in_words(const Model& model, const std::vector<const Task*>& members);

} // namespace director::analysis
