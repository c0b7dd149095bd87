#pragma once
// SPDX-License-Identifier: MIT
// Decides where a request may exist if the order of its requester's providers counts: an earlier provider goes first
// wherever it can run.

#include "compiler/analysis/requests/requests.hpp"
#include "compiler/analysis/states/choice.hpp"

#include <vector>

namespace director::analysis {

class Earlier {
public:
  Earlier(const Model& model, const Facts& facts, const Requests& requests, const Rivals& rivals, Budget& budget)
      : model_(model),
        facts_(facts),
        requests_(requests),
        rivals_(rivals),
        budget_(budget) {}

  /// Regions that meet the box, in each of which an earlier provider of the group runs instead of this one; none for
  /// one that may be pushed, which then comes first.
  std::vector<Region> before(ProviderId provider, const Box& box) const;

  /// Whether the requester, and those above it up to the program, may be active together somewhere in the box. True
  /// also if that is unknown.
  bool may_exist(const Request& request, const Box& box) const;

private:
  struct Search {
    std::vector<Region> taken; ///< by earlier providers, on the path so far
    std::vector<GroupId> path; ///< to detect cycles
    std::size_t steps = 0;
  };
  bool may_exist(const Request& request, const Box& box, Search& search) const;

  const Model& model_;
  const Facts& facts_;
  const Requests& requests_;
  const Rivals& rivals_;
  Budget& budget_;
};

} // namespace director::analysis
