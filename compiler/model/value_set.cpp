// Header: compiler/model/value_set.hpp. Test: tests/compiler/model/value_set_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/model/value_set.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

namespace director::compiler {

namespace {

using Interval = ValueSet::Interval;
constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();

/// Whether there is no value between `high` and `low`.
bool touches(std::int64_t high, std::int64_t low) { return high == largest || low <= high + 1; }

/// The first one that does not end below this value.
std::vector<Interval>::const_iterator first_from(const std::vector<Interval>& intervals, std::int64_t value) {
  return std::partition_point(intervals.begin(), intervals.end(), [&](const Interval& i) { return i.high < value; });
}

} // namespace

ValueSet ValueSet::interval(std::int64_t low, std::int64_t high) {
  ValueSet set;
  if (low <= high) set.intervals_.push_back({low, high});
  return set;
}

bool ValueSet::contains(std::int64_t value) const {
  const auto at = first_from(intervals_, value);
  return at != intervals_.end() && at->low <= value;
}

bool ValueSet::subset_of(const ValueSet& other) const {
  return std::all_of(intervals_.begin(), intervals_.end(), [&](const Interval& i) {
    const auto at = first_from(other.intervals_, i.low);
    return at != other.intervals_.end() && at->low <= i.low && i.high <= at->high;
  });
}

bool ValueSet::overlaps(const ValueSet& other) const {
  auto a = intervals_.begin();
  auto b = other.intervals_.begin();
  while (a != intervals_.end() && b != other.intervals_.end()) {
    if (std::max(a->low, b->low) <= std::min(a->high, b->high)) return true;
    if (a->high < b->high) {
      ++a;
    } else {
      ++b;
    }
  }
  return false;
}

std::int64_t ValueSet::count() const {
  // In unsigned arithmetic, because the distance of two signed numbers may be more than the largest signed one.
  std::uint64_t total = 0;
  for (const Interval& i : intervals_) {
    const std::uint64_t distance = static_cast<std::uint64_t>(i.high) - static_cast<std::uint64_t>(i.low);
    if (distance >= static_cast<std::uint64_t>(largest) - total) return largest;
    total += distance + 1;
  }
  return static_cast<std::int64_t>(total);
}

void ValueSet::add_last(const Interval& interval) {
  if (interval.low > interval.high) return;
  if (!intervals_.empty() && touches(intervals_.back().high, interval.low)) {
    intervals_.back().high = std::max(intervals_.back().high, interval.high);
  } else {
    intervals_.push_back(interval);
  }
}

ValueSet ValueSet::united(const ValueSet& other) const {
  std::vector<Interval> all;
  all.reserve(intervals_.size() + other.intervals_.size());
  std::merge(intervals_.begin(), intervals_.end(), other.intervals_.begin(), other.intervals_.end(),
             std::back_inserter(all), [](const Interval& a, const Interval& b) { return a.low < b.low; });
  ValueSet out;
  for (const Interval& i : all) out.add_last(i);
  return out;
}

ValueSet ValueSet::intersected(const ValueSet& other) const {
  ValueSet out;
  auto a = intervals_.begin();
  auto b = other.intervals_.begin();
  while (a != intervals_.end() && b != other.intervals_.end()) {
    const std::int64_t low = std::max(a->low, b->low);
    const std::int64_t high = std::min(a->high, b->high);
    if (low <= high) out.intervals_.push_back({low, high});
    if (a->high < b->high) {
      ++a;
    } else {
      ++b;
    }
  }
  return out;
}

ValueSet ValueSet::without(const ValueSet& other) const {
  ValueSet out;
  for (const Interval& i : intervals_) {
    std::int64_t low = i.low;
    bool used_up = false;
    for (auto hole = first_from(other.intervals_, low); hole != other.intervals_.end() && hole->low <= i.high; ++hole) {
      if (hole->low > low) out.intervals_.push_back({low, hole->low - 1});
      if (hole->high >= i.high) {
        used_up = true;
        break;
      }
      low = hole->high + 1;
    }
    if (!used_up) out.intervals_.push_back({low, i.high});
  }
  return out;
}

std::vector<ValueSet::Interval> pieces_of(std::int64_t low, std::int64_t high,
                                          const std::vector<const ValueSet*>& sets) {
  std::vector<std::int64_t> begins{low};
  for (const ValueSet* set : sets) {
    for (const ValueSet::Interval& interval : set->intervals()) {
      if (low < interval.low && interval.low <= high) begins.push_back(interval.low);
      if (low <= interval.high && interval.high < high) begins.push_back(interval.high + 1);
    }
  }
  std::sort(begins.begin(), begins.end());
  begins.erase(std::unique(begins.begin(), begins.end()), begins.end());
  std::vector<ValueSet::Interval> out;
  for (std::size_t i = 0; i < begins.size(); ++i)
    out.push_back({begins[i], i + 1 < begins.size() ? begins[i + 1] - 1 : high});
  return out;
}

} // namespace director::compiler
