#pragma once
// SPDX-License-Identifier: MIT
// Finds ways to run two members of a unit that want one group, where other ways of the two do not.

#include "compiler/analysis/pairs/ways.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace director::analysis {

/// A member of the pack, and the ways to run it.
struct Side {
  const Task& task;
  const std::vector<Way>& ways;
};
using Sides = std::pair<Side, Side>;

/// Where it can begin: there each `when` holds, and not only a `stay`.
Region beginning(const Input& input, const Way& way);

/// Two ways that want one group, one for each of two members.
struct ClashingWays {
  const Way* first = nullptr;
  const Way* second = nullptr;
  const Way* first_instead = nullptr; ///< two ways that do not
  const Way* second_instead = nullptr;
  std::vector<ProviderId> losers; ///< of the two, those that never run here
  bool always = false;            ///< the preferred provider of one of them never runs here, with all values of states
};

class PairSearch {
public:
  PairSearch(const Input& input, const Sides& sides);

  /// Whether some two ways of theirs want one group or can be used together.
  bool has(ProviderId id) const;
  /// Two ways that want one group, if no two ways can be used together.
  std::optional<ClashingWays> all_clash() const;
  /// Two ways that want one group somewhere where no two ways can be used together, or of which one is preferred in
  /// vain.
  std::optional<ClashingWays> run() const;

private:
  struct Pair {
    const Way* first;
    const Way* second;
    Region region;
  };

  ClashingWays make(const Pair& pair, bool always) const;
  const Pair* find_useless() const;

  const Input& input_;
  std::vector<Pair> working_, clashing_;
};

} // namespace director::analysis
