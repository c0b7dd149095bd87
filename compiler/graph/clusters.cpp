// Header: compiler/graph/clusters.hpp. Test: tests/compiler/graph/clusters_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/graph/clusters.hpp"

#include <algorithm>
#include <map>
#include <vector>

namespace director::compiler {

namespace {

class Clusters {
public:
  explicit Clusters(const Model& model) : model_(model), first_(model.edges.size()) {
    for (const EdgeId edge : model.edges.ids()) first_[edge] = edge;
    for (const Group& group : model.groups) look_below(group); // requests of the program are never in a unit
    for (const EdgeId edge : model.edges.ids()) first_[edge] = find(edge);
  }
  IdTable<EdgeId, EdgeId> take() { return std::move(first_); }

private:
  EdgeId find(EdgeId at) {
    while (first_[at] != at) at = first_[at] = first_[first_[at]];
    return at;
  }
  void join(EdgeId a, EdgeId b) {
    a = find(a), b = find(b);
    first_[std::max(a, b)] = std::min(a, b);
  }

  /// Searches down from each task that it may request. What another search has visited belongs to that one's cluster.
  void look_below(const Group& group) {
    std::vector<EdgeId> requested;
    for (const EdgeId edge : group.edges) {
      if (!model_.edges[edge].levels.empty()) requested.push_back(edge);
    }
    if (requested.size() < 2) return;
    std::map<GroupId, EdgeId> claimed;
    for (const EdgeId edge : requested) {
      std::vector<GroupId> open{model_.edges[edge].target};
      while (!open.empty()) {
        const GroupId at = open.back();
        open.pop_back();
        const auto [known, is_new] = claimed.try_emplace(at, edge);
        if (!is_new) {
          join(known->second, edge);
          continue;
        }
        for (const ProviderId provider : model_.groups[at].providers) {
          for (const Use<GroupId>& need : model_.providers[provider].needs) open.push_back(need.id);
        }
      }
    }
  }

  const Model& model_;
  IdTable<EdgeId, EdgeId> first_;
};

} // namespace

IdTable<EdgeId, EdgeId> find_clusters(const Model& model) { return Clusters(model).take(); }

} // namespace director::compiler
