#pragma once
// SPDX-License-Identifier: MIT
// A small set out of many ids: a search from one group finds few, and there are as many searches as groups.

#include <unordered_set>

namespace director::analysis {

template <class IdType>
class SparseSet {
public:
  bool contains(IdType id) const { return has_.count(id) != 0; }
  /// True if it was not in the set before.
  bool add(IdType id) { return has_.insert(id).second; }
  void remove(IdType id) { has_.erase(id); }

private:
  std::unordered_set<IdType> has_;
};

} // namespace director::analysis
