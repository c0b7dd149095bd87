#pragma once
// SPDX-License-Identifier: MIT
// Large behaviours for the compiler, as the texts of their files: of a usual shape, and of shapes that are expensive
// for some stage.

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bench {

using Files = std::map<std::string, std::string>; ///< text by name; the deployment is `main.yaml`

/// Robots of 24 groups, a module each, that share a radio, an emergency and a charge: a mission with packs, skills that
/// push one another, limbs. No errors and no warnings. `groups` is rounded down.
Files project(std::size_t groups);

/// A behaviour of one file. `size` is the number of its elements.
struct Shape {
  std::string_view name;
  std::size_t small, large; ///< sizes to compare
  std::string (*text)(std::size_t size);
};
const std::vector<Shape>& shapes();

} // namespace bench
