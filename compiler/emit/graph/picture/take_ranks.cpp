// Header: compiler/emit/graph/picture/take_ranks.hpp. Test: tests/compiler/emit/graph/picture/picture_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/graph/picture/take_ranks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace director::compiler {

namespace {

/// Of those that are optional in themselves, and of those with something optional below.
std::string words(const Edge& edge, const analysis::SideRank& rank) {
  if (!rank.optional) return std::to_string(rank.priority);
  const bool itself = std::any_of(edge.levels.begin(), edge.levels.end(), [&](const Level& level) {
    return level.optional && level.priority == rank.priority;
  });
  return fmt::format("{}{}", rank.priority, itself ? " optional" : " (something below it optional)");
}

std::string words(const Edge& edge, const std::vector<analysis::SideRank>& all) {
  std::string out;
  for (const analysis::SideRank& each : all) out += (out.empty() ? "" : " or ") + words(edge, each);
  return out;
}

} // namespace

std::vector<RanksOver> ranks_over(const std::set<analysis::Winning>& ranks) {
  std::map<analysis::SideRank, std::vector<analysis::SideRank>> losers; // by winner
  for (const analysis::Winning& each : ranks) losers[each.first].push_back(each.second);
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

std::vector<std::string> ranks_words(const Edge& taker, const Edge& loser, const std::set<analysis::Winning>& ranks,
                                     std::string_view over) {
  std::vector<std::string> out;
  for (const RanksOver& each : ranks_over(ranks))
    out.push_back(fmt::format("{} {} {}", words(taker, each.first), over, words(loser, each.second)));
  return out;
}

} // namespace director::compiler
