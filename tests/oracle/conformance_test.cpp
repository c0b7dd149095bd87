// SPDX-License-Identifier: MIT
#include "compiler/model/resolve/resolve.hpp"
#include "dsl/reading/read_behaviour.hpp"
#include "dsl/reading/read_scenario.hpp"
#include "tests/oracle/scripted.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>

namespace {

namespace dsl = director::dsl;
using director::compiler::Model;

std::vector<std::string> scenarios() {
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(director::tests::source_dir() / "tests/conformance")) {
    if (entry.path().string().ends_with(".scenario.yaml")) out.push_back(entry.path().string());
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string out;
  for (const std::string& line : lines) out += line + "\n";
  return out;
}

/// The expected lines of each step, and the actual ones.
void check(const std::string& path) {
  dsl::DiskFiles files;
  dsl::Sources sources;
  const dsl::ReadScenarioResult read = dsl::read_scenario(path, files, sources);
  REQUIRE(!dsl::has_errors(read.diagnostics));
  const dsl::ReadResult behaviour = dsl::read_behaviour(read.scenario.behaviour_path, files, sources);
  REQUIRE(!dsl::has_errors(behaviour.diagnostics));
  const auto resolved = director::compiler::resolve(behaviour.spec, sources);
  REQUIRE(!dsl::has_errors(resolved.findings));

  director::oracle::Player player(resolved.model, read.scenario);
  for (std::size_t i = 0; i < read.scenario.steps.size(); ++i) {
    const dsl::StepSpec& step = read.scenario.steps[i];
    const std::vector<std::string> lines = player.play(step);
    if (!step.expect) continue;
    std::vector<std::string> expected;
    for (const dsl::Word& line : step.expect->lines) expected.push_back(line.value);
    INFO(path << ", step " << i + 1);
    CHECK(joined(lines) == joined(expected));
  }
}

TEST_CASE("the oracle plays every scenario of the conformance folder as expected") {
  REQUIRE(scenarios().size() > 60);
  for (const std::string& path : scenarios()) check(path);
}

} // namespace
