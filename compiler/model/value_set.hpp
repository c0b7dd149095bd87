#pragma once
// SPDX-License-Identifier: MIT
// A set of values of one state: closed intervals of value numbers, sorted, disjoint and not adjacent, so that equal
// sets are equal values. Source: semantics.md, section 1 (a condition is the set of values that satisfies it).

#include <cstdint>
#include <vector>

namespace director::compiler {

class ValueSet {
public:
  struct Interval {
    std::int64_t low, high; ///< both included, low <= high
    bool operator==(const Interval&) const = default;
  };

  ValueSet() = default;
  static ValueSet interval(std::int64_t low, std::int64_t high); ///< empty where low > high
  static ValueSet single(std::int64_t value) { return interval(value, value); }

  bool empty() const { return intervals_.empty(); }
  bool contains(std::int64_t value) const;
  bool subset_of(const ValueSet& other) const; ///< the empty set is a subset of every set
  bool overlaps(const ValueSet& other) const;  ///< whether they have a value in common
  std::int64_t count() const;                  ///< how many values; saturates at the largest number
  const std::vector<Interval>& intervals() const { return intervals_; }

  /// Adds an interval, if it is not empty, that begins at or after the end of the set, without a copy: each of many
  /// takes the same time.
  void add_last(const Interval& interval);
  ValueSet united(const ValueSet& other) const;
  ValueSet intersected(const ValueSet& other) const;
  ValueSet without(const ValueSet& other) const;

  bool operator==(const ValueSet&) const = default;

private:
  std::vector<Interval> intervals_;
};

/// The domain low..high, cut where one of these sets begins or ends: within a piece, each of them contains all values
/// or none.
std::vector<ValueSet::Interval> pieces_of(std::int64_t low, std::int64_t high,
                                          const std::vector<const ValueSet*>& sets);

} // namespace director::compiler
