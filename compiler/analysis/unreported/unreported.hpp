#pragma once
// SPDX-License-Identifier: MIT
// Finds what never happens and has no finding yet. Without what depends on something else that never happens: a
// requester of its group, or a source of what it waits for. If no provider of a requested group ever runs, the group is
// reported; if a pack is never granted whole, the pack instead of its members.

#include "compiler/model/model.hpp"
#include "dsl/source/diagnostic.hpp"

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace director::analysis {

using namespace director::compiler;

using PackOf = std::pair<ProviderId, std::size_t>; ///< with the index among the provider's packs

/// What happens at some time.
struct Occurrences {
  IdSet<ProviderId> runs;
  IdSet<EdgeId> requested, granted;
  /// Packs that are granted whole; null: unknown.
  const std::set<PackOf>* whole = nullptr;
  std::map<PackOf, EdgeId> to_blame; ///< of packs that are not: the one member that prevents the others
};

struct Unreported {
  std::vector<GroupId> groups;
  IdSet<EdgeId> reported; ///< requests for those groups that a finding is about
  std::vector<EdgeId> tasks;
  std::vector<ProviderId> providers;
  std::vector<PackOf> packs;
};

/// In order. `findings`: all findings.
Unreported find_unreported(const Model& model, const Occurrences& occurrences,
                           const std::vector<dsl::Diagnostic>& findings);

/// Mandatory members of a named pack that are granted all or none, two or more; else empty.
std::vector<EdgeId> members_of(const Model& model, ProviderId provider, std::size_t pack);

/// All its entries, in order.
std::vector<const Task*> entries_of(const Model& model, EdgeId edge);

} // namespace director::analysis
