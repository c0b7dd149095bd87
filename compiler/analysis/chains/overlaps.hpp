#pragma once
// SPDX-License-Identifier: MIT
// Which of many tasks may want what another one of them wants, asked before anybody looks what each may come to hold:
// that costs time and memory for every group below every task.

#include "compiler/analysis/chains/claims.hpp"
#include "compiler/model/model.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace director::analysis {

class Overlaps {
public:
  Overlaps(const Model& model, const Branches& branches);

  /// Of entries of one list, by their targets, whether something below it, or it itself, is also below another one,
  /// whatever the states: where that is not so the claims of the two have no group in common. One walk for all of them,
  /// each group is gone through once, and none below which nobody else can come.
  std::vector<bool> among(const std::vector<GroupId>& targets);

  /// Of each entry of a list those of its priorities, ascending, at which another one may want something that it wants.
  std::vector<std::vector<std::int32_t>> priorities(const std::vector<Task>& entries);

private:
  static constexpr std::size_t no_group = static_cast<std::size_t>(-1);

  const Model& model_;
  const Branches& branches_;
  IdSet<GroupId> lonely_;                  ///< one edge leads to it at most, and likewise to all below it
  IdTable<GroupId, std::size_t> found_by_; ///< the first entry that led to it, by its place; between calls nobody
};

} // namespace director::analysis
