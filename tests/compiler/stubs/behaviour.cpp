// Header: tests/compiler/stubs/behaviour.hpp. Test: tests/compiler/stubs/wanted_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/compiler/stubs/behaviour.hpp"

#include "compiler/lower/lower.hpp"
#include "compiler/model/resolve/resolve.hpp"
#include "dsl/reading/read_behaviour.hpp"

#include <catch2/catch.hpp>

namespace director::tests {

compiler::stubs::Wanted wanted_of(const std::string& yaml, const std::string& file) {
  dsl::MemoryFiles files;
  files.add(file, yaml);
  dsl::Sources sources;
  const dsl::ReadResult read = dsl::read_behaviour(file, files, sources);
  const compiler::Resolved resolved = compiler::resolve(read.spec, sources, {});
  for (const auto* findings : {&read.diagnostics, &resolved.findings})
    for (const dsl::Diagnostic& each : *findings)
      if (each.level == dsl::Level::error) FAIL(each.message << "\n" << yaml);
  const compiler::Lowered nothing;
  return compiler::stubs::wanted({sources, resolved.model, nothing});
}

const std::string walking_robot = R"(behaviour: robot
language: 1
cpp: {namespace: team::robot}
states:
  Motion: {values: [still, moving], initial: still}
triggers: [Tick]
roots: [Walk]
groups:
  Walk:
    module: locomotion
    doc: Gets the robot somewhere.
    start: true
    stop: {sets: [Motion == still]}
    providers:
      - name: walking
        doc: Step after step.
        when: [Motion == moving]
        needs: [Legs]
        triggers: [Tick]
        tasks: {Legs: {optional: true}}
      - name: halting
        needs: [Legs]
        causing: [Motion == still within 1500 ms]
        packs:
          brake: {Legs: {}}
          rest: {}
  Legs: {module: servos}
)";

} // namespace director::tests
