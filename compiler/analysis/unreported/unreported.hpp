#pragma once
// SPDX-License-Identifier: MIT
// What never happens, and no finding speaks of: it has one of its own. Not where it could not have happened without
// something else that never does either: a requester of its group, or whoever sets what it waits for. Where no provider
// of a requested group ever runs, it is the group; where a pack is never granted whole, the pack stands for its
// members.

#include "compiler/model/model.hpp"
#include "dsl/diagnostic.hpp"

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace director::analysis {

using namespace director::compiler;

using PackOf = std::pair<ProviderId, std::size_t>; ///< with the place among the provider's

/// What happens at some time.
struct Happening {
  IdSet<ProviderId> runs;
  IdSet<EdgeId> requested, granted;
  /// Packs that are granted whole; nothing: nobody has looked.
  const std::set<PackOf>* whole = nullptr;
  std::map<PackOf, EdgeId> to_blame; ///< of packs that are not: the one member that keeps the others from it
};

struct Unreported {
  std::vector<GroupId> groups;
  IdSet<EdgeId> reported; ///< requests for those groups of which a finding speaks
  std::vector<EdgeId> tasks;
  std::vector<ProviderId> providers;
  std::vector<PackOf> packs;
};

/// In order. `findings`: all findings.
Unreported find_unreported(const Model& model, const Happening& happening,
                           const std::vector<dsl::Diagnostic>& findings);

/// Mandatory members of a named pack that are granted all or none, two or more; else empty.
std::vector<EdgeId> members_of(const Model& model, ProviderId provider, std::size_t pack);

/// Everywhere where it is asked for, in order.
std::vector<const Task*> entries_of(const Model& model, EdgeId edge);

} // namespace director::analysis
