#pragma once
// SPDX-License-Identifier: MIT
// Finds the requests for a group, and the states with which they are made.

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/analysis/requests/gaps.hpp"
#include "compiler/analysis/states/region.hpp"

#include <vector>

namespace director::analysis {

/// An entry for a group; without a provider it is one of `roots`.
struct Request {
  std::optional<ProviderId> requester;
  const Pack* pack = nullptr; ///< nothing: `roots`
  const Task* task = nullptr;
};

class Requests {
public:
  /// Those of providers that may be active, in order.
  Requests(const Model& model, const Graph& graph, const Facts& facts);

  const std::vector<Request>& of(GroupId group) const { return requests_[group]; }
  /// A region around all states with which a task for the group may exist, according to the groups above it. For a
  /// needed group without requests: any.
  const Region& region(GroupId group) const { return regions_[group]; }
  /// The regions in which a request exists: where its provider can run, with its needs.
  std::vector<Region> regions(const Request& request) const;

private:
  const Model& model_;
  mutable Ways ways_;
  IdTable<GroupId, std::vector<Request>> requests_;
  IdTable<GroupId, Region> regions_;
};

} // namespace director::analysis
