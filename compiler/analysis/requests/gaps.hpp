#pragma once
// SPDX-License-Identifier: MIT
// Finds the values of states with which no provider can run: all combinations minus the regions of the ways to run.

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/states/covering.hpp"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace director::analysis {

/// What is possible for the state in the box; added, with all that it may be, if it is not there.
Possible& possible_in(const Model& model, const Facts& facts, StateId state, Box& box);

/// Leaves of the box what is in the region. False: nothing.
bool meet(const Facts& facts, Box& box, const Region& region);

/// Disjoint boxes in which none of the ways can be used.
struct Gaps {
  std::vector<Box> boxes;
  bool all = true;     ///< false: there are too many to list, and this is one of them
  bool decided = true; ///< false: it is unknown whether there are any
};
Gaps find_gaps(const Model& model, const Facts& facts, const Box& start, const std::vector<Region>& ways,
               Budget& budget);

/// A gap that no state restricts.
inline constexpr std::string_view everywhere = "always";

/// "`A` is 0 or unset while `B` is 1": of the states in `ways` those that `box` restricts.
std::string gap_in_words(const Model& model, const Facts& facts, const Box& box);

/// The regions in which a group or provider can run: its own conditions with those of the providers that its needs can
/// lead to. The `stay` of a need counts only if it is requested too: a group that is only needed is not granted.
class Ways {
public:
  /// `counts`: conditions that are considered; others are assumed to hold.
  Ways(const Model& model, const Facts& facts, bool with_stay,
       std::function<bool(ProviderId, const ConditionUse&)> counts);

  const std::vector<Region>& of(GroupId group) { return of(group, with_stay_); }
  std::vector<Region> of(ProviderId provider) { return of(provider, with_stay_); }
  /// Of a need of the first group, while that is granted.
  const std::vector<Region>& of_need(GroupId from, GroupId need) {
    return of(need, with_stay_ && is_requested(from, need));
  }

private:
  const std::vector<Region>& of(GroupId group, bool with_stay);
  std::vector<Region> of(ProviderId provider, bool with_stay);
  bool is_requested(GroupId from, GroupId need) const;

  const Model& model_;
  const Facts& facts_;
  bool with_stay_;
  std::function<bool(ProviderId, const ConditionUse&)> counts_;
  std::map<std::pair<GroupId, bool>, std::vector<Region>> ways_; ///< with `stay` or without
};

} // namespace director::analysis
