// Header: compiler/analysis/states/region_index.hpp. Test: tests/compiler/analysis/states/region_index_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/states/region_index.hpp"

#include <algorithm>

namespace director::analysis {

namespace {

/// Below this, a linear search is faster than sorting.
constexpr std::size_t few = 16;

} // namespace

RegionIndex::RegionIndex(std::vector<Region> regions) : regions_(std::move(regions)) {
  if (regions_.size() < few) return;
  for (std::size_t place = 0; place < regions_.size(); ++place) {
    for (const auto& [state, values] : regions_[place].states) {
      for (const ValueSet::Interval& each : values.intervals())
        rows_[state].entries.push_back({each, each.high, place});
    }
  }
  for (auto& [state, row] : rows_) {
    std::sort(row.entries.begin(), row.entries.end(),
              [](const Entry& a, const Entry& b) { return a.values.low < b.values.low; });
    for (std::size_t i = 1; i < row.entries.size(); ++i)
      row.entries[i].highest = std::max(row.entries[i].highest, row.entries[i - 1].highest);
    for (std::size_t place = 0; place < regions_.size(); ++place) {
      if (regions_[place].states.count(state) == 0) row.open.push_back(place);
    }
  }
}

RegionIndex::Range RegionIndex::overlapping(const Row& row, ValueSet::Interval values) {
  const auto first = std::partition_point(row.entries.begin(), row.entries.end(),
                                          [&](const Entry& entry) { return entry.highest < values.low; });
  const auto last = std::partition_point(first, row.entries.end(),
                                         [&](const Entry& entry) { return entry.values.low <= values.high; });
  return {first, last};
}

std::size_t RegionIndex::count(const Row& row, const ValueSet& values) {
  std::size_t out = row.open.size();
  for (const ValueSet::Interval& each : values.intervals()) {
    const auto [first, last] = overlapping(row, each);
    out += static_cast<std::size_t>(last - first);
  }
  return out;
}

void RegionIndex::visit_meeting(const Region& region, std::size_t end,
                                const std::function<bool(std::size_t place)>& go_on) const {
  const Row* best = nullptr;
  const ValueSet* values = nullptr;
  std::size_t fewest = end;
  for (const auto& [state, accepted] : region.states) {
    const auto row = rows_.find(state);
    if (row == rows_.end()) continue;
    const std::size_t candidates = count(row->second, accepted);
    if (candidates >= fewest) continue;
    best = &row->second;
    values = &accepted;
    fewest = candidates;
  }
  const auto visit = [&](std::size_t place) {
    return place < end && (!compatible(region, regions_[place]) || go_on(place));
  };
  if (best == nullptr) {
    for (std::size_t place = 0; visit(place);) ++place;
    return;
  }
  std::vector<std::size_t> places = best->open;
  for (const ValueSet::Interval& each : values->intervals()) {
    const auto [first, last] = overlapping(*best, each);
    for (auto entry = first; entry != last; ++entry) places.push_back(entry->place);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  for (auto place = places.begin(); place != places.end() && visit(*place);) ++place;
}

} // namespace director::analysis
