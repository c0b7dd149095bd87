#pragma once
// SPDX-License-Identifier: MIT
// A few of many ids: what is found on the way from one group is small, and there are as many ways as groups.

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
