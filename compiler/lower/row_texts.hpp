#pragma once
// SPDX-License-Identifier: MIT
// The names of the tables' rows, as texts, with the functions by which the printers and writers of the runtime read
// them.

#include "runtime/core/inspect/why.hpp"

#include <set>
#include <string>
#include <vector>

namespace director::compiler {

class RowTexts {
public:
  RowTexts() = default;
  RowTexts(RowTexts&&) = default;
  RowTexts& operator=(RowTexts&&) = default;

  std::string behaviour;
  std::vector<std::string> groups, providers, edges, conditions, states, triggers, levels; ///< by row
  std::vector<std::vector<std::string>> values; ///< by state; empty for a range
  std::vector<LevelUse> level_uses;             ///< by add()

  /// Keeps copies of its texts.
  void add(LevelUse use);

  /// Valid as long as this object stays in place, and the tables live.
  director::Names names(const Tables& tables) const;

private:
  std::set<std::string> kept_;
};

} // namespace director::compiler
