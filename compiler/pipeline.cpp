// Door: compiler/pipeline.hpp. Test: tests/compiler/pipeline_test.cpp.
#include "compiler/pipeline.hpp"

#include "compiler/checks/analysis/facts/facts.hpp"
#include "compiler/explore/refuted.hpp"
#include "compiler/graph/deep_needs.hpp"
#include "compiler/model/lost_names.hpp"
#include "compiler/model/named_types.hpp"
#include "compiler/model/resolve.hpp"
#include "dsl/read_behaviour.hpp"

#include <algorithm>
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

/// Errors that leave nothing to run: a provider without a plan of its needs, a group that would wait for itself.
bool stops_lowering(const Model& model, const Diagnostics& findings) {
  const auto is_fatal = [](const dsl::Diagnostic& finding) {
    return finding.id == "needs_cycle" || finding.id == "needs_conflict";
  };
  const auto asks_for_itself = [](const Edge& edge) { return edge.requester == edge.target; };
  return std::any_of(findings.begin(), findings.end(), is_fatal) ||
         std::any_of(model.edges.begin(), model.edges.end(), asks_for_itself);
}

} // namespace

Checked check(const std::string& path, dsl::FileAccess& files, dsl::Sources& sources, const CheckOptions& options) {
  Checked out;

  // As it is written.
  dsl::ReadResult read = dsl::read_behaviour(path, files, sources);
  out.spec = std::move(read.spec);
  out.findings = std::move(read.diagnostics);

  // What the types of C++ are that it names. Most behaviours say all that is needed themselves.
  std::optional<Types> types;
  if (options.types != nullptr) {
    if (const auto question = named_types(out.spec, options.types->thorough())) types = options.types->read(*question);
  }
  if (types) out.headers = types->files;

  // What the names mean.
  Resolved resolved = resolve(out.spec, sources, {ids_of_checks(), options.types, types ? &*types : nullptr});
  out.model = std::move(resolved.model);
  append(out.findings, without_lost_names(sources, out.findings, std::move(resolved.findings)));
  if (!dsl::has_errors(out.findings)) {
    out.graph = make_graph(out.model);
    append(out.findings, too_deep_needs(out.model, out.graph));
  }
  out.resolved = !dsl::has_errors(out.findings);

  // Whether it makes sense. Only a deployment is a closed world.
  const bool checkable = out.resolved && out.model.deployment;
  if (checkable) {
    const checks::Facts facts = checks::find_facts(out.model, out.graph);
    append(out.findings, checks::run_checks(out.model, out.graph, facts, options.selection));
  }
  out.lowerable = checkable && !stops_lowering(out.model, out.findings);

  // Whether what its author relies on is true. Not asked of what is broken anyway.
  if (options.decide && out.lowerable && !dsl::has_errors(out.findings) && !out.model.assertions.empty()) {
    const std::vector<Verdict> verdicts = decide_assertions(out.model, states_of_check);
    append(out.findings, refuted_assertions(out.model, verdicts));
    out.undecided = undecided_assertions(out.model, verdicts);
  }

  // What of all that is reported.
  out.findings = checks::apply_allowances(out.model, std::move(out.findings), checkable);
  out.findings = checks::apply_selection(options.selection, std::move(out.findings));
  return out;
}

} // namespace director::compiler
