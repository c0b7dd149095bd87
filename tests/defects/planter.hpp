#pragma once
// SPDX-License-Identifier: MIT
// A defect that can be planted in a behaviour: for each check one or more, in the ways in which it comes about.

#include "tests/defects/robot.hpp"

#include <span>

namespace director::defects {

struct Planter {
  const char* id;
  const char* shape; ///< which way, in a few words
  /// With the defect or, all else alike, without. Both have the sign where a finding is expected, and not expected.
  void (*plant)(Robot& robot, bool defect);
};

std::span<const Planter> reading_planters();
std::span<const Planter> naming_planters();
std::span<const Planter> resource_planters();
std::span<const Planter> condition_planters();
std::span<const Planter> push_planters();
std::span<const Planter> undoing_planters();
std::span<const Planter> priority_planters();

/// All of them, by id.
std::vector<Planter> all_planters();

} // namespace director::defects
