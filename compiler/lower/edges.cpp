// Header: compiler/lower/steps.hpp. Test: tests/compiler/lower/lower_test.cpp.
// SPDX-License-Identifier: MIT
//
// The static priority table: dense numbers for the priorities of each requester, so that the engine compares small
// numbers, and the distance of two priorities has no effect.

#include "compiler/graph/clusters.hpp"
#include "compiler/lower/steps.hpp"

#include <algorithm>

namespace director::compiler {

namespace {

/// An edge without a request counts with the priority of its first level.
std::int32_t need_priority(const Edge& edge) { return edge.levels.empty() ? 0 : edge.levels.front().priority; }

/// The highest priority first.
class Places {
public:
  void add(std::int64_t priority) { keys_.push_back(-priority); }
  void sort() {
    std::sort(keys_.begin(), keys_.end());
    keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());
  }
  Index of(std::int64_t priority) const {
    return static_cast<Index>(std::lower_bound(keys_.begin(), keys_.end(), -priority) - keys_.begin());
  }

private:
  std::vector<std::int64_t> keys_;
};

/// The edges of one requester, which have consecutive ids.
void lower_siblings(const Model& model, std::span<const EdgeId> siblings, const IdTable<EdgeId, EdgeId>& clusters,
                    Lowered& out) {
  Places urgencies;
  for (const EdgeId id : siblings) {
    const Edge& edge = model.edges[id];
    urgencies.add(need_priority(edge));
    for (const Level& level : edge.levels) urgencies.add(level.priority);
  }
  urgencies.sort();
  for (const EdgeId id : siblings) {
    const Edge& edge = model.edges[id];
    director::Edge lowered;
    if (edge.requester) lowered.requester = row(*edge.requester);
    lowered.target = row(edge.target);
    lowered.need_urgency = urgencies.of(need_priority(edge));
    lowered.cluster_offset = static_cast<Index>(row(id) - row(clusters[id]));
    lowered.levels.begin = static_cast<Index>(out.levels.size());
    for (const Level& level : edge.levels) {
      out.levels.push_back({level.priority, urgencies.of(level.priority), level.optional, level.apart});
    }
    lowered.levels.end = static_cast<Index>(out.levels.size());
    out.edges.push_back(lowered);
  }
}

} // namespace

void lower_edges(const Model& model, Lowered& out) {
  const IdTable<EdgeId, EdgeId> clusters = find_clusters(model);
  std::vector<EdgeId> of_root;
  for (const EdgeId id : model.edges.ids()) {
    if (!model.edges[id].requester) of_root.push_back(id);
  }
  lower_siblings(model, of_root, clusters, out);
  out.root_edges = static_cast<Index>(of_root.size());
  for (const Group& group : model.groups) {
    lower_siblings(model, group.edges, clusters, out);
    out.most_edges = std::max(out.most_edges, static_cast<Index>(group.edges.size()));
  }
}

} // namespace director::compiler
