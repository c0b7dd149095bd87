// Header: tests/property/compiled.hpp. Test: tests/property/generate_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/compiled.hpp"

#include "compiler/lower/lower.hpp"
#include "compiler/model/resolve/resolve.hpp"
#include "compiler/play/scenario/resolve_scenario.hpp"
#include "dsl/reading/read_behaviour.hpp"
#include "dsl/reading/read_scenario.hpp"
#include "tests/oracle/parts.hpp"

#include <algorithm>

namespace director::property {

namespace {

std::string first_error(const std::vector<dsl::Diagnostic>& findings) {
  const auto at = std::find_if(findings.begin(), findings.end(),
                               [](const dsl::Diagnostic& each) { return each.level == dsl::Level::error; });
  return at == findings.end() ? "" : at->message;
}

/// Errors that only checks find, and whose absence lower() relies on.
std::string cannot_be_lowered(const compiler::Model& model) {
  for (const compiler::Edge& edge : model.edges) {
    if (edge.requester == edge.target) return "a group requests itself";
  }
  const oracle::Parts parts(model);
  for (const compiler::ProviderId p : model.providers.ids()) {
    if (parts.plans(p).empty()) return "the needs of " + model.full_name(p) + " cannot be met";
  }
  return "";
}

} // namespace

CompileResult compile(const std::string& behaviour, const std::string& scenario) {
  auto out = std::make_unique<Compiled>();
  dsl::MemoryFiles files;
  files.add("behaviour.yaml", behaviour);
  files.add("random.scenario.yaml", scenario);
  dsl::Sources sources;
  const dsl::ReadScenarioResult read_scenario = dsl::read_scenario("random.scenario.yaml", files, sources);
  if (std::string why = first_error(read_scenario.diagnostics); !why.empty()) return {nullptr, why};
  out->spec = read_scenario.scenario;
  const dsl::ReadResult read = dsl::read_behaviour(out->spec.behaviour_path, files, sources);
  if (std::string why = first_error(read.diagnostics); !why.empty()) return {nullptr, why};
  compiler::Resolved resolved = compiler::resolve(read.spec, sources);
  if (std::string why = first_error(resolved.findings); !why.empty()) return {nullptr, why};
  out->model = std::move(resolved.model);
  if (std::string why = cannot_be_lowered(out->model); !why.empty()) return {nullptr, why};
  out->lowered = compiler::lower(out->model);
  compiler::ResolvedScenario played = compiler::resolve_scenario(out->spec, out->model);
  if (std::string why = first_error(played.findings); !why.empty()) return {nullptr, why};
  out->scenario = std::move(played.scenario);
  return {std::move(out), ""};
}

} // namespace director::property
