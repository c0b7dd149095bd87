// Header: libFuzzer. Test: tests/fuzz/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// Bytes as a scenario and the behaviour that it names: it is played by the engine, or refused.
#include "compiler/lower/lower.hpp"
#include "compiler/pipeline.hpp"
#include "compiler/play/expect/test_scenario.hpp"
#include "compiler/play/scenario/resolve_scenario.hpp"
#include "dsl/reading/read_scenario.hpp"
#include "tests/fuzz/files.hpp"

using namespace director;

namespace {

/// Enough to see how time goes by; each takes a run of the engine.
constexpr std::uint64_t most_stops = 200;

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  dsl::MemoryFiles files = fuzz::in_memory(fuzz::split(fuzz::view(data, size), "a.scenario.yaml"));
  dsl::Sources sources;
  const dsl::ReadScenarioResult read = dsl::read_scenario("a.scenario.yaml", files, sources);
  fuzz::must_be_shown(read.diagnostics, sources);
  if (dsl::has_errors(read.diagnostics)) return 0;

  const compiler::Checked checked = compiler::check(read.scenario.behaviour_path, files, sources);
  fuzz::must_be_shown(checked.findings, sources);
  if (checked.spec.files.empty() || !checked.lowerable) return 0;

  const compiler::ResolvedScenario resolved = compiler::resolve_scenario(read.scenario, checked.model);
  fuzz::must_be_shown(resolved.findings, sources);
  if (dsl::has_errors(resolved.findings)) return 0;

  const compiler::Lowered lowered = compiler::lower(checked.model);
  compiler::PlayOptions options;
  options.most_stops = most_stops;
  const auto result = compiler::test_scenario(resolved.scenario, checked.model, lowered, options);
  (void)compiler::render(result, sources);
  if (result.played.refused) fuzz::must_be_shown({*result.played.refused}, sources);
  return 0;
}
