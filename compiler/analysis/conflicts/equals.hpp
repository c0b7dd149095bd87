#pragma once
// SPDX-License-Identifier: MIT
// Of each list of tasks the pairs that compete at equal rank and of which no other check tells.

#include "compiler/analysis/conflicts/contests.hpp"
#include "compiler/analysis/input.hpp"

#include <cstddef>
#include <vector>

namespace director::analysis {

/// Two of one list, by their places in it.
struct EqualPair : Rivalling {
  std::size_t earlier = 0, later = 0;
};

struct EqualList {
  const Together* together = nullptr;
  std::vector<EqualPair> pairs;
};

/// Lists without such a pair are left out. Of a long list (told.hpp) each entry with the first one that competes with
/// it for the same.
std::vector<EqualList> find_equals(const Input& input);

} // namespace director::analysis
