// Header: runtime/hosted/why/unit_contests.hpp. Test: tests/compiler/cli/commands/why_test.cpp,
// tests/runtime/live/moment_lines_test.cpp. SPDX-License-Identifier: MIT
#include "runtime/hosted/why/unit_contests.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

namespace director {

namespace {

bool has(const std::vector<Index>& list, Index row) { return std::find(list.begin(), list.end(), row) != list.end(); }

} // namespace

std::vector<Index> UnitContests::contested_by(const std::vector<Index>& edges) {
  std::map<Index, std::size_t> takers;
  for (const Index edge : edges) {
    for (const Index row : indispensable(t_.edges[edge].target)) ++takers[row];
  }
  std::vector<Index> shared, out;
  for (const auto& [row, count] : takers) {
    if (count > 1) shared.push_back(row);
  }
  std::copy_if(shared.begin(), shared.end(), std::back_inserter(out), [&](Index row) {
    return std::none_of(shared.begin(), shared.end(),
                        [&](Index other) { return other != row && cannot_do_without(other, row); });
  });
  return out;
}

bool UnitContests::cannot_do_without(Index group, Index other) { return has(indispensable(group), other); }

/// The group, and what every enabled provider of it needs, directly or not.
const std::vector<Index>& UnitContests::indispensable(Index group_row) {
  const auto known = indispensable_.find(group_row);
  if (known != indispensable_.end()) return known->second;
  indispensable_[group_row] = {group_row}; // also while the groups below are examined: a cycle ends here
  std::optional<std::vector<Index>> common;
  for (const Index provider : t_.groups[group_row].providers.rows()) {
    if (v_.enabled[provider] == 0) continue;
    std::vector<Index> needs;
    for (const Index need : t_.list(t_.providers[provider].needs)) {
      for (const Index row : indispensable(t_.edges[need].target)) needs.push_back(row);
    }
    if (!common) {
      common = std::move(needs);
    } else {
      std::erase_if(*common, [&](Index row) { return !has(needs, row); });
    }
  }
  std::vector<Index>& out = indispensable_[group_row];
  for (const Index row : common.value_or(std::vector<Index>{})) {
    if (!has(out, row)) out.push_back(row);
  }
  return out;
}

} // namespace director
