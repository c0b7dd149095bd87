#pragma once
// Members of a pack that can never be granted together, and why.

#include "compiler/checks/analysis/needs/units.hpp"
#include "compiler/checks/analysis/plans/plans.hpp"
#include "compiler/checks/check.hpp"

#include <vector>

namespace director::checks {

/// The fewest members that exclude each other: two, or the whole unit.
struct PackConflict {
  ProviderId provider{};
  const Pack* pack = nullptr;
  std::vector<const Task*> members; ///< in the order written
  UnitVerdict verdict = UnitVerdict::impossible;
};

/// Of every pack and flat list of every provider; of a flat list only pairs, since nobody says that all is asked for.
/// Of several that cannot do without one group, each with the first of them.
std::vector<PackConflict> find_pack_conflicts(const Model& model, Units& units, const Indispensable& indispensable);

/// Says what excludes what, to the bottom. `at`: the last member.
void report_pack_conflict(const Input& input, Units& units, const PackConflict& conflict, Findings& findings);

/// "`A` and `B`".
std::string members_in_words(const Model& model, const std::vector<const Task*>& members);

} // namespace director::checks
