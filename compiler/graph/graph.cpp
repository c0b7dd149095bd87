// Header: compiler/graph/graph.hpp. Test: tests/compiler/graph/graph_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/graph/graph.hpp"

namespace director::compiler {

namespace {

/// A group has one edge to each other one, so no arrow is there twice.
void add_arrow(Arrows& arrows, GroupId from, GroupId to) { arrows[from.value].push_back(to.value); }

void add_edges(Graph& graph, const Model& model) {
  for (const Edge& edge : model.edges) {
    if (!edge.requester) continue;
    if (!edge.levels.empty()) add_arrow(graph.tasks, *edge.requester, edge.target);
    if (edge.needed) add_arrow(graph.needs, *edge.requester, edge.target);
    add_arrow(graph.claims, *edge.requester, edge.target);
  }
}

/// Promises by state, so that a condition is compared with those only.
IdTable<StateId, std::vector<std::pair<ProviderId, ConditionUse>>> promises_by_state(const Model& model) {
  IdTable<StateId, std::vector<std::pair<ProviderId, ConditionUse>>> out(model.states.size());
  for (const ProviderId causer : model.providers.ids()) {
    for (const ConditionUse& promise : model.providers[causer].causing)
      out[model.conditions[promise.id].state].emplace_back(causer, promise);
  }
  return out;
}

void add_causing(Graph& graph, const Model& model) {
  const auto promises = promises_by_state(model);
  for (const ProviderId waiter : model.providers.ids()) {
    for (const ConditionUse& condition : model.providers[waiter].when) {
      for (const auto& [causer, promise] : promises[model.conditions[condition.id].state]) {
        if (model.satisfies(promise.id, condition.id)) graph.causing.push_back({causer, promise, waiter, condition});
      }
    }
  }
}

/// Over the requests alone, with one more node, root, that leads to the roots.
void add_gates(Graph& graph, const Model& model) {
  const Node root = root_node(model);
  Arrows requests = graph.tasks;
  requests.emplace_back();
  for (const Task& task : model.roots) requests[root].push_back(task.target.value);
  const std::vector<bool> reached = reachable(requests, root);
  const auto dominators = immediate_dominators(requests, root);
  graph.gate = IdTable<GroupId, std::optional<GroupId>>(model.groups.size());
  graph.requestable = IdSet<GroupId>(model.groups.size());
  for (const GroupId group : model.groups.ids()) {
    if (reached[group.value]) graph.requestable.add(group);
    const auto dominator = dominators[group.value];
    if (dominator && *dominator != root) graph.gate[group] = GroupId{*dominator};
  }
}

} // namespace

bool Graph::Causing::operator==(const Causing& other) const {
  return causer == other.causer && promise.span == other.promise.span && waiter == other.waiter &&
         condition.span == other.condition.span;
}

Arrows edge_arrows(const Model& model) {
  Arrows out(root_node(model) + 1);
  for (const Edge& edge : model.edges)
    out[edge.requester ? edge.requester->value : root_node(model)].push_back(edge.target.value);
  return out;
}

Graph make_graph(const Model& model) {
  Graph graph;
  graph.tasks.resize(model.groups.size());
  graph.needs.resize(model.groups.size());
  graph.claims.resize(model.groups.size());
  add_edges(graph, model);
  add_causing(graph, model);
  add_gates(graph, model);
  graph.task_cycles = cycles(graph.tasks);
  graph.needs_cycles = cycles(graph.needs);
  graph.order = topological_order(graph.claims);
  return graph;
}

std::vector<bool> led_to(const Graph& graph, GroupId from) {
  std::vector<bool> out = reachable(graph.claims, from.value);
  out[from.value] = true;
  return out;
}

} // namespace director::compiler
