// Header: compiler/graph/clusters.hpp. Test: tests/compiler/graph/clusters_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/graph/clusters.hpp"

#include "compiler/base/disjoint_sets.hpp"

#include <map>
#include <vector>

namespace director::compiler {

namespace {

class Clusters {
public:
  explicit Clusters(const Model& model) : model_(model), sets_(model.edges.size()) {
    for (const Group& group : model.groups) look_below(group); // requests of the program are never in a unit
  }
  IdTable<EdgeId, EdgeId> first() {
    IdTable<EdgeId, EdgeId> out(model_.edges.size());
    for (const EdgeId edge : model_.edges.ids()) out[edge] = EdgeId{sets_.find(edge.value)};
    return out;
  }

private:
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
          sets_.join(known->second.value, edge.value);
          continue;
        }
        for (const ProviderId provider : model_.groups[at].providers) {
          for (const Use<GroupId>& need : model_.providers[provider].needs) open.push_back(need.id);
        }
      }
    }
  }

  const Model& model_;
  DisjointSets sets_;
};

} // namespace

IdTable<EdgeId, EdgeId> find_clusters(const Model& model) { return Clusters(model).first(); }

} // namespace director::compiler
