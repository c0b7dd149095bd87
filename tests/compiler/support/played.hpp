#pragma once
// SPDX-License-Identifier: MIT
// A scenario from two texts to its events, for tests.

#include "compiler/lower/lower.hpp"
#include "compiler/play/play.hpp"
#include "compiler/play/scenario/resolve_scenario.hpp"
#include "dsl/reading/read_scenario.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <string>
#include <vector>

namespace director::tests {

struct LoadedScenario {
  Compiled behaviour;
  compiler::Lowered lowered;
  compiler::Scenario scenario;
  std::string findings; ///< as they are printed
};

/// The behaviour is in `test.yaml`, the scenario in `test.scenario.yaml`; `text` follows its `behaviour:`.
inline LoadedScenario load_scenario(const std::string& behaviour, const std::string& text) {
  LoadedScenario out;
  out.behaviour = compile(behaviour);
  out.lowered = compiler::lower(out.behaviour.model);
  dsl::MemoryFiles files;
  files.add("test.scenario.yaml", "behaviour: test.yaml\n" + text);
  const dsl::ReadScenarioResult read = dsl::read_scenario("test.scenario.yaml", files, out.behaviour.sources);
  INFO(dsl::render(read.diagnostics, out.behaviour.sources));
  REQUIRE(!dsl::has_errors(read.diagnostics));
  compiler::ResolvedScenario resolved = compiler::resolve_scenario(read.scenario, out.behaviour.model);
  out.scenario = std::move(resolved.scenario);
  out.findings = dsl::render(resolved.findings, out.behaviour.sources);
  return out;
}

/// All events, a line each, followed by an action that a body may not do.
inline std::vector<std::string> play(const std::string& behaviour, const std::string& text, bool decisions = false) {
  const LoadedScenario loaded = load_scenario(behaviour, text);
  INFO(loaded.findings);
  REQUIRE(loaded.findings.empty());
  std::vector<std::string> out;
  const compiler::Played played =
      compiler::play(loaded.scenario, loaded.behaviour.model, loaded.lowered, {decisions},
                     [&](const compiler::Happening& happening) { out.push_back(to_text(happening)); });
  if (played.refused) out.push_back(dsl::render(*played.refused, loaded.behaviour.sources));
  return out;
}

} // namespace director::tests
