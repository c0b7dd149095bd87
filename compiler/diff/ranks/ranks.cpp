// Header: compiler/diff/ranks/ranks.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/diff/ranks/ranks.hpp"

#include "compiler/base/list_of.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <compare>
#include <tuple>

namespace director::compiler::diff {

std::string rank_text(const Edge& edge) {
  std::vector<std::string> out;
  if (edge.levels.empty()) return "needed only";
  for (const Level& level : edge.levels)
    out.push_back(fmt::format("{}{}", level.priority, level.optional ? " (optional)" : level.apart ? " (apart)" : ""));
  return "priority " + list_of(out);
}

namespace {

/// In an order that does not depend on the text.
std::vector<Level> levels_of(const Edge& edge) {
  std::vector<Level> out = edge.levels;
  if (edge.needed) out.push_back({out.empty() ? 0 : out.front().priority, false, false});
  std::sort(out.begin(), out.end(), [](const Level& a, const Level& b) {
    return std::tuple(a.optional, a.apart, a.priority) < std::tuple(b.optional, b.apart, b.priority);
  });
  return out;
}

} // namespace

std::vector<int> orders(const Edge& one, const Edge& other) {
  std::vector<int> out;
  for (const Level& a : levels_of(one)) {
    for (const Level& b : levels_of(other)) {
      if (a.optional != b.optional) out.push_back(a.optional ? -1 : 1);
      if (a.optional == b.optional) out.push_back(a.priority < b.priority ? -1 : a.priority > b.priority ? 1 : 0);
    }
  }
  return out;
}

std::pair<bool, bool> gains_and_loses(const std::vector<int>& before, const std::vector<int>& now) {
  const auto goes_before = [](int order) { return order > 0; };
  const auto any = [&](const std::vector<int>& all) { return std::any_of(all.begin(), all.end(), goes_before); };
  if (before.size() != now.size()) return {any(now) && !any(before), any(before) && !any(now)};
  bool gains = false, loses = false;
  for (std::size_t i = 0; i < now.size(); ++i) {
    gains = gains || (goes_before(now[i]) && !goes_before(before[i]));
    loses = loses || (!goes_before(now[i]) && goes_before(before[i]));
  }
  return {gains, loses};
}

bool is_order_alike(const Edge& one, const Edge& old_one, const Edge& other, const Edge& old_other) {
  const auto relation = [](const Level& a, const Level& b) {
    return std::tuple(a.optional, a.apart, b.optional, b.apart, a.priority <=> b.priority);
  };
  const auto relations = [&](const Edge& first, const Edge& second) {
    std::vector<decltype(relation({}, {}))> out;
    for (const Level& a : levels_of(first)) {
      for (const Level& b : levels_of(second)) out.push_back(relation(a, b));
    }
    return out;
  };
  return relations(one, other) == relations(old_one, old_other);
}

} // namespace director::compiler::diff
