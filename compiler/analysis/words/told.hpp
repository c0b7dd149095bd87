#pragma once
// SPDX-License-Identifier: MIT
// Of many that are in conflict over one thing, each is told of with the first of them, and not with every other: fifty
// tasks that want one group are 49 findings at most, not 1,225. Of lists as people write them every pair is told of: who mends
// or allows one pair has not mended the others.

#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace director::analysis {

/// Of lists up to this long every pair is told of.
inline constexpr std::size_t told_in_pairs = 20;

/// Entries of one list by their places in it. `Thing`: what makes two of them rivals, and them and a third one.
template <class Thing>
class Told {
public:
  explicit Told(std::size_t entries) : circles_(entries) {}

  /// The list is long, and both were told of with one and the same other entry, over the same thing.
  bool covers(std::size_t a, std::size_t b) const {
    if (circles_.size() <= told_in_pairs) return false;
    const std::set<std::size_t>&few = circles_[a].size() < circles_[b].size() ? circles_[a] : circles_[b],
          &many = &few == &circles_[a] ? circles_[b] : circles_[a];
    for (const std::size_t circle : few)
      if (many.count(circle) != 0) return true;
    return false;
  }

  void tell(std::size_t first, std::size_t second, const Thing& thing) {
    const std::size_t circle = numbers_.try_emplace({first, thing}, numbers_.size()).first->second;
    circles_[first].insert(circle);
    circles_[second].insert(circle);
  }

private:
  std::vector<std::set<std::size_t>> circles_;
  std::map<std::pair<std::size_t, Thing>, std::size_t> numbers_;
};

} // namespace director::analysis
