#pragma once
// SPDX-License-Identifier: MIT
// What the rows of tables are called, as texts, behind the functions by which the printers and writers of the runtime
// ask for them.

#include "runtime/core/inspect/why.hpp"

#include <string>
#include <vector>

namespace director::compiler {

struct RowTexts {
  std::string behaviour;
  std::vector<std::string> groups, providers, edges, conditions, states, triggers, levels; ///< by row
  std::vector<std::vector<std::string>> values; ///< by state; empty for a range

  /// For as long as this object lives and stays where it is, and the tables live.
  director::Names names(const Tables& tables) const;
};

} // namespace director::compiler
