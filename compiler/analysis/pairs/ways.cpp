// Header: compiler/analysis/pairs/ways.hpp. Test: tests/compiler/checks/helps_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/pairs/ways.hpp"

#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/states/choice.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace director::analysis {

namespace {

/// Limit: tasks with more ways to run are not compared.
constexpr std::size_t most_ways_of_task = 64;

bool is_open(const Input& input, const Region& region, const std::vector<Region>& taken) {
  return !region.empty() &&
         find_covering(input.model, region, taken, input.facts.values, input.shared.budget()) == Covering::open;
}

/// The regions of the first ones.
std::vector<Region> regions_before(const std::vector<Way>& ways, std::size_t end) {
  std::vector<Region> out;
  for (std::size_t i = 0; i < end; ++i) out.push_back(ways[i].combination.region);
  return out;
}

/// Whether a provider of the second task runs beside a way of the first one, or while that one waits (null), where
/// `taken` does not hold.
bool runs_beside(const Input& input, const Way* first, const std::vector<Region>& taken, const std::vector<Way>& second,
                 ProviderId id) {
  const auto is_free = [&](const Way& way) { return first == nullptr || groups_in_common(*first, way).empty(); };
  std::vector<Region> before = taken;
  for (const Way& way : second) {
    if (!is_free(way)) continue;
    Region region = way.combination.region;
    if (first != nullptr) region.meet(first->combination.region);
    if (way.provider() == id && is_open(input, region, before)) return true;
    before.push_back(way.combination.region);
  }
  return false;
}

} // namespace

std::optional<std::vector<Way>> find_ways(Units& units, GroupId group) {
  std::vector<Way> out;
  const bool complete = units.visit({group}, false, [&](const Combination& combination) {
    Way way{combination, {}};
    for (const Combination::Pick& pick : combination.picks) way.groups.push_back(pick.group);
    std::sort(way.groups.begin(), way.groups.end());
    out.push_back(std::move(way));
    return out.size() <= most_ways_of_task;
  });
  if (!complete || out.size() > most_ways_of_task) return std::nullopt;
  return out;
}

std::vector<GroupId> groups_in_common(const Way& a, const Way& b) {
  std::vector<GroupId> both;
  std::set_intersection(a.groups.begin(), a.groups.end(), b.groups.begin(), b.groups.end(), std::back_inserter(both));
  return both;
}

bool comes_first(const Input& input, const std::vector<Way>& ways, std::size_t at) {
  return is_open(input, ways[at].combination.region, regions_before(ways, at));
}

bool run_beside(const Input& input, const std::vector<Way>& ways, const std::vector<Way>& others) {
  for (std::size_t i = 0; i < ways.size(); ++i) {
    if (!comes_first(input, ways, i)) continue;
    bool runs = false;
    for (std::size_t j = 0; j < ways.size() && !runs; ++j) {
      if (ways[j].provider() != ways[i].provider()) continue;
      for (const Way& other : others) {
        Region region = ways[j].combination.region;
        region.meet(other.combination.region);
        runs = runs || is_open(input, region, regions_before(ways, j));
      }
    }
    if (!runs) return false;
  }
  return true;
}

bool leaves_all(const Input& input, const std::vector<Way>& first, const std::vector<Way>& second, bool one) {
  for (std::size_t i = 0; i < second.size(); ++i) {
    if (!one && !comes_first(input, second, i)) continue;
    const ProviderId id = second[i].provider();
    bool runs = runs_beside(input, nullptr, regions_before(first, first.size()), second, id);
    for (std::size_t j = 0; j < first.size() && !runs; ++j)
      runs = runs_beside(input, &first[j], regions_before(first, j), second, id);
    if (runs == one) return one;
  }
  return !one;
}

} // namespace director::analysis
