#pragma once
// SPDX-License-Identifier: MIT
// Of many that are in conflict over one thing, each is told of with the first of them, and not with every other: fifty
// tasks that want one group are 49 findings at most, not 1,225. Of lists as people write them every pair is told of:
// who mends or allows one pair has not mended the others.

#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace director::analysis {

/// Of lists up to this long every pair is told of.
inline constexpr std::size_t longest_with_all_pairs = 20;

/// Entries of one list by their places in it. `Thing`: what makes two of them rivals, and them and a third one.
template <class Thing>
class ReportedPairs {
public:
  explicit ReportedPairs(std::size_t entries) : conflicts_(entries) {}

  /// The list is long, and both were told of with one and the same other entry, over the same thing.
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
