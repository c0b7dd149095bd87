// Door: compiler/checks/check.hpp. Test: compiler/checks/task_cycle.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::checks {

namespace {

bool has_mandatory(const Edge& edge) {
  return std::any_of(edge.levels.begin(), edge.levels.end(), [](const Level& level) { return !level.optional; });
}

/// Where one group asks for another, first with a mandatory level.
Span entry(const Model& model, GroupId from, GroupId to) {
  Span first{};
  for (const ProviderId provider : model.groups[from].providers) {
    for (const Pack& pack : model.providers[provider].packs) {
      for (const Task& task : pack.tasks) {
        if (task.target != to) continue;
        const std::vector<Level>& levels = model.edges[task.edge].levels;
        if (std::any_of(task.levels.begin(), task.levels.end(),
                        [&](const Task::NamedLevel& named) { return !levels[named.level].optional; }))
          return task.span;
        if (first == Span{}) first = task.span;
      }
    }
  }
  return first;
}

void report_circle(const Model& model, const std::vector<Node>& path, Findings& findings) {
  std::vector<GroupId> groups;
  for (const Node node : path) groups.push_back(GroupId{node});
  const GroupId last = groups[groups.size() - 2];
  dsl::Diagnostic& finding =
      findings.add(entry(model, last, groups.back()),
                   fmt::format("{}: that one is never granted", chain_in_words(model, groups, "requests")));
  for (std::size_t i = 0; i + 2 < groups.size(); ++i)
    finding.notes.push_back({entry(model, groups[i], groups[i + 1]),
                             fmt::format("{} requests {}", name_of(model, groups[i]), name_of(model, groups[i + 1])),
                             i == 0 ? dsl::Note::Link::first : dsl::Note::Link::next});
  finding.help = "make this request `optional`, or leave it out";
}

} // namespace

void task_cycle(const Input& input, Findings& findings) {
  const Model& model = input.model;
  Arrows mandatory(model.groups.size());
  for (const Edge& edge : model.edges) {
    if (!edge.requester || edge.levels.empty()) continue;
    if (*edge.requester == edge.target) {
      findings
          .add(entry(model, edge.target, edge.target), fmt::format("{} requests itself", name_of(model, edge.target)))
          .help = "a task goes on with another pack; it cannot ask for itself";
    } else if (has_mandatory(edge)) {
      mandatory[edge.requester->value].push_back(edge.target.value);
    }
  }
  for (const std::vector<Node>& nodes : cycles(mandatory))
    report_circle(model, shortest_path(mandatory, nodes[0], nodes[0]), findings);
}

} // namespace director::checks
