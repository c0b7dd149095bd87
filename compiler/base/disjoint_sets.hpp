#pragma once
// SPDX-License-Identifier: MIT
// Disjoint sets of the numbers below a count, each at first alone (union-find). A set is represented by its smallest
// number.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace director::compiler {

class DisjointSets {
public:
  explicit DisjointSets(std::size_t count) : above_(count) {
    std::iota(above_.begin(), above_.end(), std::uint32_t{0});
  }
  std::uint32_t find(std::uint32_t at) {
    while (above_[at] != at) at = above_[at] = above_[above_[at]];
    return at;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    above_[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::uint32_t> above_;
};

} // namespace director::compiler
