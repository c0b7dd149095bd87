// SPDX-License-Identifier: MIT
#include "compiler/lower/lower.hpp"
#include "compiler/pipeline.hpp"
#include "compiler/play/expect/test_scenario.hpp"
#include "compiler/play/scenario/resolve_scenario.hpp"
#include "dsl/reading/read_scenario.hpp"
#include "dsl/source/render.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <string>

using namespace director;
using namespace director::tests;

namespace {

void check_scenario(const std::filesystem::path& path) {
  dsl::DiskFiles disk;
  dsl::Sources sources, behaviour_sources;
  const dsl::ReadScenarioResult read = dsl::read_scenario(path.string(), disk, sources);
  INFO(dsl::render(read.diagnostics, sources));
  REQUIRE(read.diagnostics.empty());
  const std::string behaviour = (path.parent_path() / read.scenario.behaviour.value).string();
  const compiler::Checked checked = compiler::check(behaviour, disk, behaviour_sources);
  INFO(dsl::render(checked.findings, behaviour_sources));
  REQUIRE(checked.lowerable);
  const compiler::ResolvedScenario resolved = compiler::resolve_scenario(read.scenario, checked.model);
  INFO(dsl::render(resolved.findings, sources));
  REQUIRE(resolved.findings.empty());
  const compiler::ScenarioResult result =
      compiler::test_scenario(resolved.scenario, checked.model, compiler::lower(checked.model));
  INFO(compiler::render(result, sources));
  CHECK(result.holds());
}

} // namespace

TEST_CASE("a field player plays from the start of the program to a kick") {
  check_scenario(source_dir() / "behaviours/robocup/robocup.scenario.yaml");
}

TEST_CASE("a robot that has fallen gets up and walks on") {
  check_scenario(source_dir() / "behaviours/robocup/fall_and_get_up.scenario.yaml");
}
