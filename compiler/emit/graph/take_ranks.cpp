// Header: compiler/emit/graph/take_ranks.hpp. Test: tests/compiler/emit/graph/picture_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/graph/take_ranks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace director::compiler {

namespace {

/// Of those that are optional in themselves, and of those with something optional below.
std::string words(const Edge& edge, const Standing& standing) {
  if (!standing.optional) return std::to_string(standing.priority);
  const bool itself = std::any_of(edge.levels.begin(), edge.levels.end(), [&](const Level& level) {
    return level.optional && level.priority == standing.priority;
  });
  return fmt::format("{}{}", standing.priority, itself ? " optional" : " (something below it optional)");
}

std::string words(const Edge& edge, const std::vector<Standing>& all) {
  std::string out;
  for (const Standing& each : all) out += (out.empty() ? "" : " or ") + words(edge, each);
  return out;
}

} // namespace

std::vector<RanksOver> ranks_over(const std::set<Winning>& ranks) {
  std::map<Standing, std::vector<Standing>> losers; // by winner
  for (const Winning& each : ranks) losers[each.first].push_back(each.second);
  std::vector<RanksOver> out;
  for (const auto& [first, second] : losers) {
    const auto same =
        std::find_if(out.begin(), out.end(), [&](const RanksOver& known) { return known.second == second; });
    if (same != out.end()) {
      same->first.push_back(first);
    } else {
      out.push_back({{first}, second});
    }
  }
  return out;
}

std::vector<std::string> ranks_words(const Edge& taker, const Edge& loser, const std::set<Winning>& ranks,
                                     std::string_view over) {
  std::vector<std::string> out;
  for (const RanksOver& each : ranks_over(ranks))
    out.push_back(fmt::format("{} {} {}", words(taker, each.first), over, words(loser, each.second)));
  return out;
}

} // namespace director::compiler
