#pragma once
// SPDX-License-Identifier: MIT
// Which of many regions meet another one, without asking each of them. That many providers of a group are told apart by
// one state is common; that is what it is quick for.

#include "compiler/analysis/states/region.hpp"

#include <cstddef>
#include <map>
#include <vector>

namespace director::analysis {

class RegionIndex {
public:
  explicit RegionIndex(std::vector<Region> regions);

  /// The places of those that are compatible with the region, ascending; only below `end`.
  std::vector<std::size_t> meeting(const Region& region, std::size_t end) const;
  const Region& operator[](std::size_t place) const { return regions_[place]; }

private:
  struct Entry {
    ValueSet::Interval values;
    std::int64_t highest; ///< of all entries up to this one
    std::size_t place;
  };
  /// How the regions stand to one state.
  struct Row {
    std::vector<Entry> entries;    ///< ascending by where they begin
    std::vector<std::size_t> open; ///< regions that do not speak of it
  };
  using Range = std::pair<std::vector<Entry>::const_iterator, std::vector<Entry>::const_iterator>;

  static Range overlapping(const Row& row, ValueSet::Interval values);
  static std::size_t count(const Row& row, const ValueSet& values);

  std::vector<Region> regions_;
  std::map<StateId, Row> rows_; ///< none where the regions are few
};

} // namespace director::analysis
