// Header: tests/property/units.hpp. Test: tests/property/property_test.cpp, tests/property/ranks_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/units.hpp"

#include <algorithm>
#include <tuple>

namespace director::property {

using oracle::EdgeId;

compiler::Level Units::level(EdgeId edge) const {
  const std::vector<compiler::Level>& levels = model_.edges[edge].levels;
  if (const auto& asked = now_.requests[edge.value]) return levels.at(*asked);
  compiler::Level out;
  if (!levels.empty()) out.priority = levels.front().priority;
  return out;
}

bool Units::is_member(EdgeId edge) const {
  return model_.edges[edge].requester && now_.requests[edge.value] && level(edge).shares_unit();
}

std::vector<EdgeId> Units::of(EdgeId edge) const {
  if (!is_member(edge)) return {edge};
  std::vector<EdgeId> out;
  for (const EdgeId e : model_.groups[*model_.edges[edge].requester].edges) {
    if (is_member(e)) out.push_back(e);
  }
  return out;
}

std::vector<EdgeId> Units::mates(EdgeId member) const {
  std::vector<EdgeId> out = of(member);
  out.erase(std::remove(out.begin(), out.end(), member), out.end());
  return out;
}

bool Units::stands_before(EdgeId a, EdgeId b) const {
  const auto rank = [&](EdgeId edge) {
    const std::uint64_t stamp = now_.requests[edge.value] ? view_.request[edge.value].stamp : ~std::uint64_t{0};
    return std::tuple(-std::int64_t{level(edge).priority}, stamp, edge);
  };
  return rank(a) < rank(b);
}

EdgeId Units::first_of(EdgeId edge) const {
  const std::vector<EdgeId> all = of(edge);
  return *std::min_element(all.begin(), all.end(), [&](EdgeId a, EdgeId b) { return stands_before(a, b); });
}

} // namespace director::property
