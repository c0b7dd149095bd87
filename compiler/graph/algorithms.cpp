// Header: compiler/graph/algorithms.hpp. Test: tests/compiler/graph/algorithms_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/graph/algorithms.hpp"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dominator_tree.hpp>
#include <boost/graph/strong_components.hpp>

#include <algorithm>
#include <deque>
#include <utility>

namespace director::compiler {

namespace {

using BoostGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::bidirectionalS>;

BoostGraph boost_graph(const Arrows& arrows) {
  BoostGraph graph(arrows.size());
  for (Node from = 0; from < arrows.size(); ++from) {
    for (const Node to : arrows[from]) boost::add_edge(from, to, graph);
  }
  return graph;
}

/// All components, those with incoming arrows first: the order in which Tarjan's algorithm finishes them.
std::vector<std::vector<Node>> components(const Arrows& arrows) {
  std::vector<std::size_t> of(arrows.size());
  if (arrows.empty()) return {};
  const BoostGraph graph = boost_graph(arrows);
  const std::size_t count =
      boost::strong_components(graph, boost::make_iterator_property_map(of.begin(), get(boost::vertex_index, graph)));
  std::vector<std::vector<Node>> out(count);
  for (Node node = 0; node < arrows.size(); ++node) out[of[node]].push_back(node);
  return out;
}

} // namespace

std::vector<std::vector<Node>> cycles(const Arrows& arrows) {
  std::vector<std::vector<Node>> out;
  for (std::vector<Node>& nodes : components(arrows)) {
    const std::vector<Node>& first = arrows[nodes[0]];
    if (nodes.size() > 1 || std::find(first.begin(), first.end(), nodes[0]) != first.end())
      out.push_back(std::move(nodes));
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<Node> topological_order(const Arrows& arrows) {
  std::vector<std::vector<Node>> found = components(arrows);
  std::vector<Node> out;
  for (auto nodes = found.rbegin(); nodes != found.rend(); ++nodes) out.insert(out.end(), nodes->begin(), nodes->end());
  return out;
}

std::vector<std::optional<Node>> immediate_dominators(const Arrows& arrows, Node start) {
  // Boost's algorithm is wrong if an unreachable node has an arrow to a reachable one.
  std::vector<bool> reached = reachable(arrows, start);
  reached[start] = true;
  Arrows paths = arrows;
  for (Node node = 0; node < arrows.size(); ++node) {
    if (!reached[node]) paths[node].clear();
  }
  const BoostGraph graph = boost_graph(paths);
  const auto none = boost::graph_traits<BoostGraph>::null_vertex();
  std::vector<std::size_t> dominator(arrows.size(), none);
  boost::lengauer_tarjan_dominator_tree(
      graph, start, boost::make_iterator_property_map(dominator.begin(), get(boost::vertex_index, graph)));
  std::vector<std::optional<Node>> out(arrows.size());
  for (Node node = 0; node < arrows.size(); ++node) {
    if (dominator[node] != none) out[node] = static_cast<Node>(dominator[node]);
  }
  return out;
}

std::vector<bool> reachable(const Arrows& arrows, Node start) { return reachable(arrows, std::vector{start}); }

std::vector<bool> reachable(const Arrows& arrows, std::vector<Node> open) {
  std::vector<bool> out(arrows.size(), false);
  while (!open.empty()) {
    const Node node = open.back();
    open.pop_back();
    for (const Node next : arrows[node]) {
      if (out[next]) continue;
      out[next] = true;
      open.push_back(next);
    }
  }
  return out;
}

std::vector<Node> shortest_path(const Arrows& arrows, Node from, Node to, const std::vector<bool>* within) {
  std::vector<std::optional<Node>> before(arrows.size());
  std::deque<Node> open{from};
  while (!open.empty()) {
    const Node node = open.front();
    open.pop_front();
    for (const Node next : arrows[node]) {
      if (before[next] || (within && !(*within)[next])) continue;
      before[next] = node;
      if (next != to) {
        open.push_back(next);
        continue;
      }
      std::vector<Node> path{to};
      for (Node at = node; at != from; at = *before[at]) path.push_back(at);
      path.push_back(from);
      std::reverse(path.begin(), path.end());
      return path;
    }
  }
  return {};
}

} // namespace director::compiler
