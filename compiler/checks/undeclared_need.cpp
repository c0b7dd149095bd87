// Header: compiler/checks/check.hpp. Test: compiler/checks/undeclared_need.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/conflicts/contenders.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/shared/shared.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

namespace director::checks {

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
      finding.help = may_be_needed(input, id, contended)
                         ? fmt::format("need {} too, or make the request `apart` or `optional`", task)
                         : "make the request `apart` or `optional`";
    }
  }
}

} // namespace director::checks
