// SPDX-License-Identifier: MIT
#include "compiler/lower/level_names.hpp"
#include "compiler/lower/lower.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;

TEST_CASE("a level has the first of its names, and the first level of a task that a provider requests has none") {
  const tests::Compiled compiled = tests::compile(R"(behaviour: test
language: 1
roots: {Play: {priority: {calm: 1, hot: 2}}}
groups:
  Play:
    packs:
      near: {Look: {priority: {low: 10, high: 50}}}
      far: {Look: {priority: {slow: 10, fast: 50}}}
  Look: {}
)");
  const compiler::Lowered lowered = compiler::lower(compiled.model);
  CHECK(compiler::level_names(compiled.model, lowered) == std::vector<std::string>{"calm", "hot", "", "high"});
}

} // namespace
