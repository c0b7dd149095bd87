#pragma once
// SPDX-License-Identifier: MIT
// A behaviour from its text to the result of an exploration, for tests.

#include "compiler/explore/report.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <string>

namespace director::tests {

/// A walk must halt before a kick. The test adds the states.
inline const std::string walker_groups = R"(roots: {Walk: {priority: 10}, Kick: {priority: 20}}
groups:
  Walk:
    providers:
      - {name: walking, needs: [Legs], sets: [Pose == moving], tasks: [Legs]}
      - {name: halting, needs: [Legs], causing: [Pose == standing], tasks: [Legs]}
  Kick: {when: [Pose == standing], needs: [Legs], tasks: [Legs]}
  Legs: {}
)";

inline compiler::Exploration explore_all(const compiler::Ground& ground, std::size_t bound = 100'000,
                                         unsigned threads = 2) {
  compiler::ExploreOptions options;
  options.bound = bound;
  options.threads = threads;
  options.behaviour = "behaviour.yaml";
  return compiler::explore(ground, options);
}

} // namespace director::tests
