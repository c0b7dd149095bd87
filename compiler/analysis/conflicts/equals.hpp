#pragma once
// SPDX-License-Identifier: MIT
// For each list of tasks the pairs that compete at equal rank and that no other check reports.

#include "compiler/analysis/conflicts/contests.hpp"
#include "compiler/analysis/input.hpp"

#include <cstddef>
#include <vector>

namespace director::analysis {

/// Two entries of one list, by their places.
struct EqualPair : Rivalling {
  std::size_t earlier = 0, later = 0;
  bool open = false; ///< which of them takes the group if both want it at once depends on what is requested with them
};

struct EqualList {
  const Together* together = nullptr;
  std::vector<EqualPair> pairs;
};

/// Lists without such a pair are left out. In a long list (reported_pairs.hpp) each entry is paired with the first one
/// that competes with it for the same.
std::vector<EqualList> find_equals(const Input& input);

} // namespace director::analysis
