#pragma once
// SPDX-License-Identifier: MIT
// What a granted task is certain to take, and whether it may have to wait for a condition.

#include "compiler/analysis/input.hpp"
#include "compiler/analysis/states/region.hpp"

#include <map>
#include <unordered_map>
#include <vector>

namespace director::analysis {

using Groups = std::vector<GroupId>; ///< sorted, each once

bool has(const Groups& groups, GroupId group);
Groups in_common(const Groups& a, const Groups& b);

struct Certain {
  Groups own;     ///< by its needs, from the beginning
  Groups all;     ///< and by what it requests in every pack of every provider
  Groups depends; ///< all groups on which this depends
};

class Certainties {
public:
  explicit Certainties(const Input& input) : input_(input) {}

  const Certain& of(GroupId group);

  /// Whether some provider's conditions hold in the whole region.
  bool never_waits(GroupId group, const Region& region);

private:
  bool never_waits(GroupId group);
  /// What it requests as a mandatory task in each of its packs.
  Groups requested_by(const Provider& provider, Groups& depends);

  const Input& input_;
  std::map<GroupId, Certain> certain_; ///< a map, for stable addresses: `of` returns references
  std::unordered_map<GroupId, bool> never_waits_;
};

} // namespace director::analysis
