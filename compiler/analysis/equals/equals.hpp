#pragma once
// SPDX-License-Identifier: MIT
// For each list of tasks the pairs that compete at equal rank, by themselves or by the place of a unit, and that no
// other check reports.

#include "compiler/analysis/equals/contests.hpp"
#include "compiler/analysis/input.hpp"

#include <cstddef>
#include <vector>

namespace director::analysis {

/// Two entries of one list, by their indices.
struct EqualPair : Rivalling {
  std::size_t earlier = 0, later = 0;
  bool open = false; ///< which of them takes the group if both want it at once depends on what is requested with them
  /// The first one ranks behind the second, which is apart, but its unit is tried at the place of this member, with the
  /// priority of the second. Null: they are equal by themselves.
  const Task* leader = nullptr;
};

struct EqualList {
  const Together* together = nullptr;
  std::vector<EqualPair> pairs;
};

/// Lists without such a pair are left out. In a long list (reported_pairs.hpp) each entry is paired with the first one
/// that competes with it for the same.
std::vector<EqualList> find_equals(const Input& input);

} // namespace director::analysis
