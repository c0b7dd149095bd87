// Header: compiler/graph/deep_needs.hpp. Test: tests/compiler/graph/deep_needs_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/graph/deep_needs.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler {

namespace {

/// For each group the maximal length of a path along its needs, itself included; a cycle counts with all its groups.
std::vector<std::size_t> depths(const Graph& graph) {
  const std::size_t size = graph.needs.size();
  std::vector<std::vector<Node>> parts(size); // the cycle of each group, in the row of its first one
  std::vector<Node> part_of(size);
  for (Node node = 0; node < size; ++node) part_of[node] = node;
  for (const std::vector<Node>& cycle : graph.needs_cycles) {
    for (const Node node : cycle) part_of[node] = cycle.front();
    parts[cycle.front()] = cycle;
  }
  std::vector<std::size_t> out(size, 0);
  const std::vector<Node> order = topological_order(graph.needs);
  for (auto node = order.rbegin(); node != order.rend(); ++node) {
    const Node part = part_of[*node];
    if (out[*node] != 0) continue;
    const std::vector<Node> members = parts[part].empty() ? std::vector<Node>{*node} : parts[part];
    std::size_t below = 0;
    for (const Node member : members) {
      for (const Node next : graph.needs[member]) below = std::max(below, part_of[next] == part ? 0 : out[next]);
    }
    for (const Node member : members) out[member] = members.size() + below;
  }
  return out;
}

} // namespace

std::vector<dsl::Diagnostic> too_deep_needs(const Model& model, const Graph& graph) {
  const std::vector<std::size_t> depth = depths(graph);
  for (const GroupId group : model.groups.ids()) {
    // Only the lowest group that is too deep is reported: below it no group is, or only groups of its own cycle.
    if (depth[group.value] <= deepest_needs + 1) continue;
    for (const ProviderId provider : model.groups[group].providers) {
      for (const Use<GroupId>& need : model.providers[provider].needs) {
        if (depth[need.id.value] > deepest_needs + 1 && depth[need.id.value] < depth[group.value]) continue;
        return {{"input_limit",
                 dsl::Level::error,
                 need.span,
                 fmt::format("`{}` needs more than {} groups, one below the other", model.groups[group].name.value,
                             deepest_needs),
                 {},
                 "let groups need directly what is further down, or leave some of these groups out"}};
      }
    }
  }
  return {};
}

} // namespace director::compiler
