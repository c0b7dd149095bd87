#pragma once
// SPDX-License-Identifier: MIT
// The faults of a scenario of a behaviour, for tests: found when it is read, resolved or played, whichever is first.

#include "compiler/lower/lower.hpp"
#include "compiler/play/play.hpp"
#include "compiler/play/scenario/resolve_scenario.hpp"
#include "dsl/reading/read_scenario.hpp"

#include <string>
#include <vector>

namespace director::tests {

inline std::vector<dsl::Diagnostic> scenario_findings(const std::string& path, const compiler::Model& model,
                                                      dsl::FileAccess& files, dsl::Sources& sources) {
  const dsl::ReadScenarioResult read = dsl::read_scenario(path, files, sources);
  if (dsl::has_errors(read.diagnostics)) return read.diagnostics;
  const compiler::ResolvedScenario resolved = compiler::resolve_scenario(read.scenario, model);
  if (dsl::has_errors(resolved.findings)) return resolved.findings;
  const compiler::Lowered lowered = compiler::lower(model);
  const compiler::Played played =
      compiler::play(resolved.scenario, model, lowered, {}, [](const compiler::Happening&) {});
  if (played.refused) return {*played.refused};
  return resolved.findings; // warnings
}

} // namespace director::tests
