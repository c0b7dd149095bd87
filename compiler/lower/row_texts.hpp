#pragma once
// SPDX-License-Identifier: MIT
// The names of the tables' rows, as texts, with the functions by which the printers and writers of the runtime read
// them.

#include "runtime/core/inspect/why.hpp"

#include <string>
#include <vector>

namespace director::compiler {

struct RowTexts {
  std::string behaviour;
  std::vector<std::string> groups, providers, edges, conditions, states, triggers, levels; ///< by row
  std::vector<std::vector<std::string>> values; ///< by state; empty for a range

  /// Valid as long as this object stays in place, and the tables live.
  director::Names names(const Tables& tables) const;
};

} // namespace director::compiler
