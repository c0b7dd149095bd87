#pragma once
// SPDX-License-Identifier: MIT
// Finds what has to change outside, after the row's beginning, so that the column can run.

#include "compiler/transitions/player.hpp"

#include <cstddef>
#include <vector>

namespace director::compiler::transitions {

struct Changes {
  /// Each a choice of values to try, the fewest first. Behind the first `usual` ones also what keeps providers from
  /// running that are preferred to those of the column: the row may have let them run.
  std::vector<Values> all;
  std::size_t usual = 0;
};

Changes changes_for(const Model& model, const Beginning& row, const Beginning& column);

} // namespace director::compiler::transitions
