#pragma once
// SPDX-License-Identifier: MIT
// Finds the regions that meet another one, without testing each of them. It is fast for a common case: the many
// providers of a group differ by one state.

#include "compiler/analysis/states/region.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

namespace director::analysis {

class RegionIndex {
public:
  explicit RegionIndex(std::vector<Region> regions);

  /// Visits the places of those that are compatible with the region, ascending, only below `end`, until `go_on` is
  /// false.
  void visit_meeting(const Region& region, std::size_t end, const std::function<bool(std::size_t place)>& go_on) const;
  const Region& operator[](std::size_t place) const { return regions_[place]; }

private:
  struct Entry {
    ValueSet::Interval values;
    std::int64_t highest; ///< of all entries up to this one
    std::size_t place;
  };
  /// The regions by one state.
  struct Row {
    std::vector<Entry> entries;    ///< ascending by where they begin
    std::vector<std::size_t> open; ///< regions that do not restrict it
  };
  using Range = std::pair<std::vector<Entry>::const_iterator, std::vector<Entry>::const_iterator>;

  static Range overlapping(const Row& row, ValueSet::Interval values);
  static std::size_t count(const Row& row, const ValueSet& values);

  std::vector<Region> regions_;
  std::map<StateId, Row> rows_; ///< empty if the regions are few
};

} // namespace director::analysis
