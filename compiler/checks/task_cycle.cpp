// Header: compiler/checks/check.hpp. Test: compiler/checks/task_cycle.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/conflicts.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace director::checks {

namespace {

/// Needs by which the last requester would still want what is above it.
std::vector<std::string> needs_above(const Model& model, const TaskCycle& cycle) {
  std::vector<std::string> out;
  for (const ProviderId id : model.groups[cycle.last_requester()].providers) {
    for (const Use<GroupId>& need : model.providers[id].needs) {
      std::string name = name_of(model, need.id);
      if (needs_lead_to(model, need.id, cycle.groups.back()) && std::find(out.begin(), out.end(), name) == out.end())
        out.push_back(std::move(name));
    }
  }
  return out;
}

void report(const Input& input, const TaskCycle& cycle, Findings& findings) {
  const Model& model = input.model;
  const std::vector<GroupId>& groups = cycle.groups;
  dsl::Diagnostic& finding = findings.add(
      request_span(model, cycle.last_requester(), groups.back()),
      fmt::format("{}: {} is never granted", chain_in_words(model, groups, "requests"),
                  cycle.is_known ? "that one" : "the one of these that leads back to where the cycle was entered"));
  finding.rules_out = {finding.span}; // which one it is depends on where the cycle is entered
  for (std::size_t i = 0; i + 2 < groups.size(); ++i) {
    finding.notes.push_back({request_span(model, groups[i], groups[i + 1]),
                             fmt::format("{} requests {}", name_of(model, groups[i]), name_of(model, groups[i + 1])),
                             i == 0 ? dsl::Note::Link::first : dsl::Note::Link::next});
    finding.rules_out.push_back(finding.notes.back().span);
  }
  const std::vector<std::string> needs = needs_above(model, cycle);
  const std::string leave =
      needs.empty() ? "leave it out" : fmt::format("leave it out, and the need for {}", list_of(needs));
  finding.help = cycle.is_known ? fmt::format("{}: {} goes on with another pack, or says `done` and is requested again",
                                              leave, name_of(model, groups.back()))
                                : (needs.empty() ? "make this request `optional`, or " : "") + leave;
}

void report_loop(const Input& input, GroupId group, Findings& findings) {
  dsl::Diagnostic& finding = findings.add(request_span(input.model, group, group),
                                          fmt::format("{} requests itself", name_of(input.model, group)));
  finding.rules_out = {finding.span};
  finding.help = "a task goes on with another pack; it cannot request itself";
}

} // namespace

void task_cycle(const Input& input, Findings& findings) {
  for (const TaskCycle& cycle : input.conflicts.task_cycles()) {
    if (cycle.groups.size() == 2)
      report_loop(input, cycle.groups.front(), findings);
    else
      report(input, cycle, findings);
  }
}

} // namespace director::checks
