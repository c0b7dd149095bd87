#pragma once
// SPDX-License-Identifier: MIT
// Compares the ways to run two tasks: a provider and a plan of its needs each.

#include "compiler/analysis/input.hpp"
#include "compiler/analysis/needs/units.hpp"

#include <optional>
#include <vector>

namespace director::analysis {

/// One way to run a task.
struct Way {
  Combination combination;
  std::vector<GroupId> groups; ///< that it takes; sorted
  ProviderId provider() const { return combination.picks.front().provider; }
};

/// In the order in which they are tried. Empty: there are more than 64, which are not compared.
std::optional<std::vector<Way>> find_ways(Units& units, GroupId group);

/// Sorted.
std::vector<GroupId> groups_in_common(const Way& a, const Way& b);

/// Whether it is chosen at some time, if nothing else holds what it takes.
bool comes_first(const Input& input, const std::vector<Way>& ways, std::size_t at);

/// Whether each provider of the task that would run alone also runs where some way of the other task may, if no way of
/// the one takes anything from the other.
bool run_beside(const Input& input, const std::vector<Way>& ways, const std::vector<Way>& others);

/// Whether each provider of the second task that would run alone also runs if the first task is always requested with
/// it and goes before it; `one`: whether one of them does.
bool leaves_all(const Input& input, const std::vector<Way>& first, const std::vector<Way>& second, bool one = false);

} // namespace director::analysis
