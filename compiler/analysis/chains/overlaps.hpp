#pragma once
// SPDX-License-Identifier: MIT
// Finds out which of many tasks may want what another one wants, before computing what each may come to hold: that
// costs time and memory for every group below every task.

#include "compiler/analysis/chains/claims.hpp"
#include "compiler/model/model.hpp"

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace director::analysis {

class Overlaps {
public:
  Overlaps(const Model& model, const Branches& branches);

  /// For entries of one list, by their targets: whether some group below an entry, or its target, is also below another
  /// entry, whatever the states. If not, the claims of the two have no group in common. One search for all of them
  /// visits each group once, and skips those below which only one entry can lead.
  std::vector<bool> among(const std::vector<GroupId>& targets);

  /// For each entry of a list those of these priorities of it, ascending, at which another one may want the same group.
  std::vector<std::vector<std::int32_t>> among(const std::vector<Task>& entries,
                                               const std::vector<std::set<std::int32_t>>& priorities);

private:
  static constexpr std::size_t no_group = static_cast<std::size_t>(-1);

  const Model& model_;
  const Branches& branches_;
  IdSet<GroupId> lonely_;                  ///< at most one edge leads to it, and likewise to all below it
  IdTable<GroupId, std::size_t> found_by_; ///< the first entry that led to it, by its place; no_group between calls
};

} // namespace director::analysis
