// Header: tests/defects/planter.hpp. Test: itself.
// SPDX-License-Identifier: MIT
#include "tests/defects/planter.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace director::defects {

std::vector<Planter> all_planters() {
  std::vector<Planter> all;
  for (const auto& some : {reading_planters(), naming_planters(), resource_planters(), condition_planters(),
                           push_planters(), undoing_planters(), priority_planters()}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  std::stable_sort(all.begin(), all.end(), [](const Planter& a, const Planter& b) { return std::string(a.id) < b.id; });
  return all;
}

} // namespace director::defects
