// Header: compiler/checks/check.hpp. Test: compiler/checks/undone_by_itself.md.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/undoing.hpp"
#include "compiler/analysis/needs/needs.hpp"
#include "compiler/analysis/rounds/own_undoing.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/checks/check.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace director::checks {

namespace {

/// What every message begins with.
std::string sets(const Model& model, const OwnUndoing& undoing) {
  return fmt::format("{} may {} {}", undoing.by.name, undoing.by.promised ? "cause" : "set",
                     name_of(model, undoing.entry.id));
}

void add_company(const Model& model, const OwnUndoing& undoing, std::vector<dsl::Note>& notes) {
  if (undoing.member == nullptr) return;
  notes.push_back({undoing.member->span, fmt::format("{} is granted together with {}", name_of(model, undoing.task),
                                                     name_of(model, undoing.waits))});
}

void report_push(const Model& model, const OwnUndoing& undoing, Findings& findings) {
  const std::string waiter = name_of(model, undoing.want.waiter), condition = name_of(model, undoing.want.condition.id);
  dsl::Diagnostic& finding = findings.add(
      undoing.entry.span, fmt::format("{}, and then {} is cut off until {} causes {} again", sets(model, undoing),
                                      waiter, name_of(model, undoing.causer), condition));
  add_waiter(model, undoing.want, finding.notes);
  add_chain(model, need_path(model, undoing.waits, model.providers[undoing.want.waiter].group), finding.notes);
  add_company(model, undoing, finding.notes);
  add_chain(model, undoing.path, finding.notes);
  finding.notes.push_back(causes(model, undoing.causer, undoing.want.condition.id));
  finding.help = stay_help(model, undoing.waits, undoing.want, undoing.values, undoing.timing);
}

void report_root(const Model& model, const OwnUndoing& undoing, Findings& findings) {
  const auto& [waiter, use, causers, pushed] = undoing.want;
  dsl::Diagnostic& finding =
      findings.add(undoing.entry.span,
                   fmt::format("{}, and then {} is cut off, perhaps for ever: it cannot push {}, which causes {}",
                               sets(model, undoing), name_of(model, waiter), name_of(model, undoing.causer),
                               name_of(model, use.id)));
  finding.notes.push_back(runs_only_while(model, waiter, use));
  add_chain(model, undoing.path, finding.notes);
  finding.notes.push_back(causes(model, undoing.causer, use.id));
  finding.notes.push_back(
      {undoing.root->span, fmt::format("{} goes before {}", name_of(model, model.providers[undoing.causer].group),
                                       name_of(model, undoing.task))});
  finding.help = stay_help(model, undoing.want, undoing.values);
}

void report_stop(const Model& model, const OwnUndoing& undoing, Findings& findings) {
  dsl::Diagnostic& finding =
      findings.add(undoing.entry.span,
                   fmt::format("{}, and then {} is cut off until {} stops: the two go round", sets(model, undoing),
                               name_of(model, undoing.want.waiter), name_of(model, undoing.by.group)));
  finding.notes.push_back(runs_only_while(model, undoing.want.waiter, undoing.want.condition));
  add_company(model, undoing, finding.notes);
  add_chain(model, undoing.path, finding.notes);
  finding.notes.push_back(*undoing.stop);
  finding.help = stay_help(model, undoing.want, undoing.values);
}

} // namespace

void undone_by_itself(const Input& input, Findings& findings) {
  for (const OwnUndoing& undoing : find_own_undoing(input)) {
    switch (undoing.back) {
    case OwnUndoing::Back::push: report_push(input.model, undoing, findings); break;
    case OwnUndoing::Back::root: report_root(input.model, undoing, findings); break;
    case OwnUndoing::Back::stop: report_stop(input.model, undoing, findings); break;
    }
  }
}

} // namespace director::checks
