// Header: compiler/checks/check.hpp. Test: compiler/checks/unreserved_tasks.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/contenders.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace director::checks {

namespace {

/// Whether the provider keeps a skill beside a planner. With a need for the skill it would not be granted before the
/// planner has decided, and the skill would be stopped.
bool keeps_skill(const Input& input, ProviderId id, const Task& task) {
  if (!stop_matters(input.model, task.target)) return false;
  const std::vector<Request>& requests = input.shared.requests().of(input.model.providers[id].group);
  return std::any_of(requests.begin(), requests.end(), [&](const Request& request) {
    return request.requester && find_deferring(input, *request.pack, *request.task, task.target);
  });
}

} // namespace

void unreserved_tasks(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const ProviderId id : model.providers.ids()) {
    if (!input.facts.active.contains(id) || find_needed_task(model, model.providers[id]) != nullptr) continue;
    const std::vector<ContendedTask> all = find_contended_tasks(input, id);
    if (all.empty() || keeps_skill(input, id, *all.front().task)) continue;
    const ContendedTask& contended = all.front();
    const std::string task = name_of(model, contended.task->target);
    dsl::Diagnostic& finding =
        findings.add(contended.task->span,
                     fmt::format("{} needs none of its tasks: it can start, and then {} be refused", name_of(model, id),
                                 all.size() == 1 ? task + " can" : fmt::format("{} of them can", all.size())));
    add_chain(model, need_path(model, contended.task->target, contended.group), finding.notes);
    add_contender(model, contended.contender, contended.group, finding);
    for (std::size_t i = 1; i < all.size(); ++i)
      finding.notes.push_back({all[i].task->span, fmt::format("the same for {}", name_of(model, all[i].task->target))});
    std::vector<std::string> needed;
    bool possible = true, pushes = false;
    for (const ContendedTask& each : all) {
      needed.push_back(name_of(model, each.task->target));
      possible = possible && may_be_needed(input, id, each);
      pushes = pushes || !input.shared.wants_of(each.task->target).empty();
    }
    const std::string them = all.size() == 1 ? "it" : "them", by = name_of(model, id);
    finding.help = possible ? fmt::format("need {}, if {} is of no use without {}", list_of(needed), by, them)
                            : fmt::format("make those tasks `apart`{} that {} can do without",
                                          // It would go after what it has to push.
                                          pushes ? "" : " or `optional`", by);
  }
}

} // namespace director::checks
