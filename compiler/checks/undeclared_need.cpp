// Header: compiler/checks/check.hpp. Test: compiler/checks/undeclared_need.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/contenders.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::checks {

namespace {

/// If the task were needed, another task of the provider could want what it holds, and never get it.
bool is_wanted_below(const Input& input, const Provider& provider, GroupId task) {
  const auto& parts = input.shared.indispensable().of(task);
  return parts && std::any_of(provider.packs.begin(), provider.packs.end(), [&](const Pack& pack) {
           return std::any_of(pack.tasks.begin(), pack.tasks.end(), [&](const Task& other) {
             const Claims& below = input.shared.claims(other.target);
             return other.target != task &&
                    std::any_of(parts->begin(), parts->end(), [&](GroupId part) { return below.contains(part); });
           });
         });
}

} // namespace

void undeclared_need(const Input& input, Findings& findings) {
  const Model& model = input.model;
  for (const ProviderId id : model.providers.ids()) {
    const Use<GroupId>* need = find_needed_task(model, model.providers[id]);
    if (need == nullptr || !input.facts.active.contains(id)) continue;
    for (const ContendedTask& contended : find_contended_tasks(input, id)) {
      const std::string task = name_of(model, contended.task->target);
      dsl::Diagnostic& finding =
          findings.add(contended.task->span,
                       fmt::format("{} needs {} and not {}, which it requests too: it can start and then be refused",
                                   name_of(model, id), name_of(model, need->id), task));
      finding.notes.push_back({need->span, fmt::format("{} needs {}", name_of(model, id), name_of(model, need->id))});
      add_chain(model, need_path(model, contended.task->target, contended.group), finding.notes);
      add_contender(model, contended.contender, contended.group, finding);
      finding.help = is_wanted_below(input, model.providers[id], contended.task->target)
                         ? "make the request `apart` or `optional`"
                         : fmt::format("need {} too, or make the request `apart` or `optional`", task);
    }
  }
}

} // namespace director::checks
