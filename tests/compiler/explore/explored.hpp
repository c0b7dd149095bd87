#pragma once
// A behaviour from its text to what an exploration finds, for tests.

#include "compiler/explore/report.hpp"
#include "tests/compiler/support/compiled.hpp"

namespace director::tests {

inline compiler::Exploration explore_all(const compiler::Ground& ground, std::size_t bound = 100'000,
                                         unsigned threads = 2) {
  compiler::ExploreOptions options;
  options.bound = bound;
  options.threads = threads;
  options.behaviour = "behaviour.yaml";
  return compiler::explore(ground, options);
}

} // namespace director::tests
