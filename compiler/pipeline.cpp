// Header: compiler/pipeline.hpp. Test: tests/compiler/pipeline_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/pipeline.hpp"

#include "compiler/analysis/facts/facts.hpp"
#include "compiler/explore/never_runs.hpp"
#include "compiler/explore/refuted.hpp"
#include "compiler/graph/deep_needs.hpp"
#include "compiler/model/named_types.hpp"
#include "compiler/model/resolve/lost_names.hpp"
#include "compiler/model/resolve/resolve.hpp"
#include "dsl/reading/read_behaviour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <utility>

namespace director::compiler {

namespace {

using Diagnostics = std::vector<dsl::Diagnostic>;

void append(Diagnostics& all, Diagnostics more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
  dsl::sort_by_place(all);
}

std::vector<std::string> ids_of_checks() {
  std::vector<std::string> out;
  for (const checks::Registered& check : checks::registered()) out.emplace_back(check.id);
  return out;
}

bool has(const dsl::Diagnostic& finding, checks::Consequence consequence) {
  const checks::Registered* check = checks::find_registered(finding.id);
  return check != nullptr && checks::consequence_of(*check) == consequence;
}

bool any_has(const Diagnostics& findings, checks::Consequence consequence) {
  return std::any_of(findings.begin(), findings.end(),
                     [&](const dsl::Diagnostic& finding) { return has(finding, consequence); });
}

/// Whether there are errors without tables to run, like a group that would wait for itself.
bool stops_lowering(const Model& model, const Diagnostics& findings) {
  return any_has(findings, checks::Consequence::nothing_runs) ||
         std::any_of(model.edges.begin(), model.edges.end(),
                     [](const Edge& edge) { return edge.requester == edge.target; });
}

bool has_all_but_providers(const Diagnostics& findings) {
  return std::all_of(findings.begin(), findings.end(), [](const dsl::Diagnostic& finding) {
    return finding.level != dsl::Level::error || has(finding, checks::Consequence::stand_in);
  });
}

bool reports_never(const dsl::Diagnostic& finding) {
  const checks::Registered* check = checks::find_registered(finding.id);
  return check != nullptr && checks::reports_never(*check);
}

/// Drops findings about a substitute for a missing thing, which are not about the file.
Diagnostics without_stand_ins(const Diagnostics& before, Diagnostics found) {
  std::set<dsl::Span> missing;
  for (const dsl::Diagnostic& finding : before) {
    if (has(finding, checks::Consequence::stand_in)) missing.insert(finding.span);
  }
  if (missing.empty()) return found;
  std::erase_if(found, [&](const dsl::Diagnostic& finding) {
    return reports_never(finding) || missing.contains(finding.span) ||
           std::any_of(finding.notes.begin(), finding.notes.end(),
                       [&](const dsl::Note& note) { return missing.contains(note.span); });
  });
  return found;
}

/// Whether no decision has too many trials to wait for.
bool is_quick_to_run(const Diagnostics& findings) {
  return !any_has(findings, checks::Consequence::nothing_is_explored);
}

} // namespace

Checked check(const std::string& path, dsl::FileAccess& files, dsl::Sources& sources, const CheckOptions& options) {
  Checked out;

  // Read the files.
  dsl::ReadResult read = dsl::read_behaviour(path, files, sources);
  out.spec = std::move(read.spec);
  out.findings = std::move(read.diagnostics);

  // Read the C++ types that are named, if they are needed. Most behaviours are complete without them.
  std::optional<Types> types;
  if (options.types != nullptr) {
    if (const auto question = named_types(out.spec, options.types->thorough())) types = options.types->read(*question);
  }
  if (types) {
    out.headers = types->files;
    out.types_fault = types->fault;
  }

  // Resolve the names.
  Resolved resolved = resolve(out.spec, sources, {ids_of_checks(), options.types, types ? &*types : nullptr});
  out.model = std::move(resolved.model);
  append(out.findings, without_lost_names(sources, out.findings, std::move(resolved.findings)));
  if (has_all_but_providers(out.findings)) {
    out.graph = make_graph(out.model);
    append(out.findings, too_deep_needs(out.model, out.graph));
  }
  out.resolved = !dsl::has_errors(out.findings);

  // Run the checks. Only a deployment is a closed world.
  const bool checkable = has_all_but_providers(out.findings) && out.model.deployment;
  if (checkable) {
    const analysis::Facts facts = analysis::find_facts(out.model, out.graph);
    append(out.findings,
           without_stand_ins(out.findings, checks::run_checks(out.model, out.graph, facts, options.selection)));
  }
  out.lowerable = out.resolved && checkable && !stops_lowering(out.model, out.findings);

  // Decide the assertions. Errors that leave something to run do not affect them.
  if (options.decide > 0 && out.lowerable && is_quick_to_run(out.findings) && !out.model.assertions.empty()) {
    const std::vector<Verdict> verdicts = decide_assertions(Ground(out.model), options.decide);
    append(out.findings, refuted_assertions(out.model, verdicts));
    out.undecided = undecided_assertions(out.model, verdicts);
    out.verdicts = std::make_shared<const std::vector<Verdict>>(verdicts);
  }

  // Explore for what never runs.
  if (options.explore > 0 && out.lowerable && is_quick_to_run(out.findings)) {
    NeverRuns never = find_never_runs(out.model, options.explore, out.findings, options.progress);
    append(out.findings, std::move(never.findings));
    if (!never.open.empty()) out.undecided.push_back("what never runs: " + never.open);
  }

  // Select the findings to report.
  checks::Sifted sifted =
      checks::apply_allowances(out.model, std::move(out.findings), checkable && !options.selection.only_errors);
  out.findings = checks::apply_selection(options.selection, std::move(sifted.reported));
  out.allowed = std::move(sifted.allowed);
  return out;
}

} // namespace director::compiler
