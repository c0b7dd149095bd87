// Door: compiler/graph/clusters.hpp. Test: tests/compiler/graph/clusters_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/graph/clusters.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace director::compiler {

namespace {

class Clusters {
public:
  explicit Clusters(const Model& model) : model_(model), claims_(model.groups.size()), first_(model.edges.size()) {
    std::map<std::optional<GroupId>, std::map<GroupId, EdgeId>> claimed; // of each requester: who may claim what
    for (const EdgeId edge : model.edges.ids()) {
      first_[edge] = edge;
      if (model.edges[edge].levels.empty() || !model.edges[edge].requester) continue; // roots are never a unit
      auto& of_requester = claimed[model.edges[edge].requester];
      for (const GroupId group : claims(model.edges[edge].target)) {
        const auto [at, is_new] = of_requester.try_emplace(group, edge);
        if (!is_new) join(at->second, edge);
      }
    }
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

  /// The group, and all that a plan of it may contain.
  const std::vector<GroupId>& claims(GroupId group) {
    if (claims_[group]) return *claims_[group];
    std::set<GroupId> found{group};
    std::vector<GroupId> open{group};
    while (!open.empty()) {
      const GroupId at = open.back();
      open.pop_back();
      for (const ProviderId provider : model_.groups[at].providers) {
        for (const Use<GroupId>& need : model_.providers[provider].needs) {
          if (found.insert(need.id).second) open.push_back(need.id);
        }
      }
    }
    return claims_[group].emplace(found.begin(), found.end());
  }

  const Model& model_;
  IdTable<GroupId, std::optional<std::vector<GroupId>>> claims_;
  IdTable<EdgeId, EdgeId> first_;
};

} // namespace

IdTable<EdgeId, EdgeId> find_clusters(const Model& model) { return Clusters(model).take(); }

} // namespace director::compiler
