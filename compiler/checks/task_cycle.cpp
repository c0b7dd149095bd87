// Header: compiler/checks/check.hpp. Test: compiler/checks/task_cycle.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/shared/shared.hpp"
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

/// `path` begins and ends with the same group. Where all that leads to the circle comes in by one group, it begins
/// there: then its last request is never granted. Else which one is depends on where it came in.
void report_circle(const Input& input, std::vector<Node> path, Findings& findings) {
  const Model& model = input.model;
  const auto begins_right = [&] {
    return input.shared.chains().always_below(GroupId{path[path.size() - 2]}, GroupId{path.front()});
  };
  bool is_known = begins_right();
  for (std::size_t turn = 1; !is_known && turn < path.size(); ++turn) {
    path.pop_back();
    std::rotate(path.begin(), path.begin() + 1, path.end());
    path.push_back(path.front());
    is_known = begins_right();
  }
  std::vector<GroupId> groups;
  for (const Node node : path) groups.push_back(GroupId{node});
  const GroupId last = groups[groups.size() - 2];
  dsl::Diagnostic& finding = findings.add(
      entry(model, last, groups.back()),
      fmt::format("{}: {} is never granted", chain_in_words(model, groups, "requests"),
                  is_known ? "that one" : "the one of these that leads back to where the circle was entered"));
  finding.rules_out = {finding.span}; // which one it is depends on where the circle is entered
  for (std::size_t i = 0; i + 2 < groups.size(); ++i) {
    finding.notes.push_back({entry(model, groups[i], groups[i + 1]),
                             fmt::format("{} requests {}", name_of(model, groups[i]), name_of(model, groups[i + 1])),
                             i == 0 ? dsl::Note::Link::first : dsl::Note::Link::next});
    finding.rules_out.push_back(finding.notes.back().span);
  }
  finding.help = "make this request `optional`, or leave it out";
}

} // namespace

void task_cycle(const Input& input, Findings& findings) {
  const Model& model = input.model;
  Arrows mandatory(model.groups.size());
  for (const Edge& edge : model.edges) {
    if (!edge.requester || edge.levels.empty()) continue;
    if (*edge.requester == edge.target) {
      dsl::Diagnostic& finding = findings.add(entry(model, edge.target, edge.target),
                                              fmt::format("{} requests itself", name_of(model, edge.target)));
      finding.rules_out = {finding.span};
      finding.help = "a task goes on with another pack; it cannot ask for itself";
    } else if (has_mandatory(edge)) {
      mandatory[edge.requester->value].push_back(edge.target.value);
    }
  }
  for (const std::vector<Node>& nodes : cycles(mandatory))
    report_circle(input, shortest_path(mandatory, nodes[0], nodes[0]), findings);
}

} // namespace director::checks
