#pragma once
// SPDX-License-Identifier: MIT
// Limits the findings about many entries that conflict over one thing: each is reported with the first of them, and not
// with every other: fifty tasks that want one group are at most 49 findings, not 1,225. In lists of usual length every
// pair is reported, as correcting or allowing one pair does not correct the others.

#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace director::analysis {

/// In lists up to this long every pair is reported.
inline constexpr std::size_t longest_with_all_pairs = 20;

/// Entries of one list by their indices. `Thing`: what makes two of them rivals, and them and a third one.
template <class Thing>
class ReportedPairs {
public:
  explicit ReportedPairs(std::size_t entries) : conflicts_(entries) {}

  /// Whether the list is long, and both were reported with the same other entry, over the same thing.
  bool covers(std::size_t a, std::size_t b) const {
    if (conflicts_.size() <= longest_with_all_pairs) return false;
    const std::set<std::size_t>&few = conflicts_[a].size() < conflicts_[b].size() ? conflicts_[a] : conflicts_[b],
          &many = &few == &conflicts_[a] ? conflicts_[b] : conflicts_[a];
    for (const std::size_t conflict : few)
      if (many.count(conflict) != 0) return true;
    return false;
  }

  void add(std::size_t first, std::size_t second, const Thing& thing) {
    const std::size_t conflict = numbers_.try_emplace({first, thing}, numbers_.size()).first->second;
    conflicts_[first].insert(conflict);
    conflicts_[second].insert(conflict);
  }

private:
  std::vector<std::set<std::size_t>> conflicts_;
  std::map<std::pair<std::size_t, Thing>, std::size_t> numbers_;
};

} // namespace director::analysis
