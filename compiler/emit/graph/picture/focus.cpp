// Header: compiler/emit/graph/picture/focus.hpp. Test: tests/compiler/emit/graph/picture/picture_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/graph/picture/focus.hpp"

#include "compiler/graph/algorithms.hpp"

#include <algorithm>
#include <limits>

namespace director::compiler {

namespace {

constexpr std::size_t endless = std::numeric_limits<std::size_t>::max();

Arrows reversed(const Arrows& arrows) {
  Arrows out(arrows.size());
  for (Node from = 0; from < arrows.size(); ++from) {
    for (const Node to : arrows[from]) out[to].push_back(from);
  }
  return out;
}

/// `starts`, and everything at most `depth` arrows behind them.
std::vector<Node> within(const Arrows& arrows, const std::vector<GroupId>& starts, std::size_t depth) {
  std::vector<Node> found;
  std::vector<bool> seen(arrows.size(), false);
  const auto add = [&](Node node) {
    if (!seen[node]) found.push_back(node);
    seen[node] = true;
  };
  for (const GroupId start : starts) add(start.value);
  std::size_t begin = 0;
  for (std::size_t away = 0; away < depth && begin < found.size(); ++away) {
    const std::size_t end = found.size();
    for (; begin < end; ++begin) {
      const std::vector<Node> next = arrows[found[begin]]; // `found` grows
      for (const Node node : next) add(node);
    }
  }
  return found;
}

} // namespace

IdSet<GroupId> groups_in_focus(const Model& model, const Graph& graph, const PictureOptions& options) {
  IdSet<GroupId> out(model.groups.size());
  if (options.focus.empty()) {
    for (const GroupId id : model.groups.ids()) out.add(id);
    return out;
  }
  const std::size_t depth = options.depth.value_or(endless);
  const auto add = [&](const std::vector<Node>& nodes) {
    for (const Node node : nodes) out.add(GroupId{node});
  };
  add(within(reversed(graph.claims), options.focus, depth)); // what can reach it
  add(within(graph.claims, options.focus, depth));           // what it can hold
  std::vector<bool> focused(model.groups.size(), false);
  for (const GroupId id : options.focus) focused[id.value] = true;
  for (const Graph::Causing& causing : graph.causing) { // what it pushes, and what pushes it
    const GroupId waits = model.providers[causing.waiter].group, pushed = model.providers[causing.causer].group;
    if (depth < 1 || (!focused[waits.value] && !focused[pushed.value])) continue;
    out.add(waits);
    out.add(pushed);
  }
  if (depth < 2) return out;
  const Arrows needed_by = reversed(graph.needs); // what may conflict with it
  for (const Node resource : within(graph.needs, options.focus, depth - 1)) {
    if (!focused[resource]) add(needed_by[resource]);
  }
  return out;
}

IdSet<GroupId> leading_to_focus(const Model& model, const Graph& graph, const PictureOptions& options) {
  IdSet<GroupId> out(model.groups.size());
  if (options.depth == std::size_t{0}) return out;
  for (const Node node : within(reversed(graph.claims), options.focus, endless)) out.add(GroupId{node});
  return out;
}

bool is_in_focus(GroupId taker, GroupId loser, const std::vector<bool>& over, const Graph& graph,
                 const PictureOptions& options) {
  if (options.depth == std::size_t{0}) return false;
  const std::vector<bool> below = reachable(graph.claims, {taker.value, loser.value});
  return std::any_of(options.focus.begin(), options.focus.end(), [&](GroupId id) {
    if (id == taker || id == loser) return true;
    if (!below[id.value]) return false;
    std::vector<bool> holds = reachable(graph.claims, id.value);
    holds[id.value] = true;
    for (std::size_t i = 0; i < over.size(); ++i) {
      if (over[i] && holds[i]) return true;
    }
    return false;
  });
}

} // namespace director::compiler
