// Header: compiler/graph/graph.hpp. Test: tests/compiler/graph/graph_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/graph/graph.hpp"

#include <fmt/format.h>

namespace director::compiler {

namespace {

std::string names(const Model& model, const std::vector<Node>& nodes) {
  std::string out;
  for (const Node node : nodes) out += (out.empty() ? "" : ", ") + model.groups[GroupId{node}].name.value;
  return out;
}

std::string arrows_of(const Model& model, std::string_view title, const Arrows& arrows) {
  std::string out = fmt::format("{}\n", title);
  for (const GroupId group : model.groups.ids()) {
    const std::vector<Node>& to = arrows[group.value];
    if (!to.empty()) out += fmt::format("  {} -> {}\n", model.groups[group].name.value, names(model, to));
  }
  return out;
}

std::string cycles_of(const Model& model, std::string_view title, const std::vector<std::vector<Node>>& found) {
  std::string out;
  for (const std::vector<Node>& nodes : found) out += fmt::format("{} {}\n", title, names(model, nodes));
  return out;
}

} // namespace

std::string print_graph(const Model& model, const Graph& graph) {
  std::string out = arrows_of(model, "tasks", graph.tasks) + arrows_of(model, "needs", graph.needs) + "causing\n";
  for (const Graph::Causing& arrow : graph.causing) {
    out += fmt::format("  {} ({}) -> {} ({})\n", model.full_name(arrow.causer), model.conditions[arrow.promise.id].text,
                       model.full_name(arrow.waiter), model.conditions[arrow.condition.id].text);
  }
  out += cycles_of(model, "cycle of tasks:", graph.task_cycles);
  out += cycles_of(model, "cycle of needs:", graph.needs_cycles);
  out += fmt::format("order: {}\n", names(model, graph.order));
  out += "gates\n";
  for (const GroupId group : model.groups.ids()) {
    const std::string& name = model.groups[group].name.value;
    if (!graph.requestable.contains(group)) {
      out += fmt::format("  {}: nothing leads to it\n", name);
    } else if (graph.gate[group]) {
      out += fmt::format("  {}: only by {}\n", name, model.groups[*graph.gate[group]].name.value);
    }
  }
  return out;
}

} // namespace director::compiler
