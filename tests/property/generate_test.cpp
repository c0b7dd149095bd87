// SPDX-License-Identifier: MIT
#include "tests/property/compiled.hpp"
#include "tests/property/generate.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director::property;

TEST_CASE("a seed always gives the same documents") {
  const Documents a = generate(7), b = generate(7);
  CHECK(to_yaml(a.behaviour) == to_yaml(b.behaviour));
  CHECK(to_yaml(a.scenario) == to_yaml(b.scenario));
  CHECK(to_yaml(a.behaviour) != to_yaml(generate(8).behaviour));
}

TEST_CASE("random behaviours and scenarios have no errors") {
  std::size_t largest = 0, smallest = 99;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Documents documents = generate(seed);
    const CompileResult result = compile(to_yaml(documents.behaviour), to_yaml(documents.scenario));
    INFO("seed " << seed << ": " << result.why);
    REQUIRE(result.compiled);
    largest = std::max(largest, result.compiled->model.groups.size());
    smallest = std::min(smallest, result.compiled->model.groups.size());
  }
  CHECK(largest > 30);
  CHECK(smallest == 3);
}

TEST_CASE("random behaviours of several mostly independent parts have no errors") {
  int several = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Documents documents = generate_parts(seed);
    const CompileResult result = compile(to_yaml(documents.behaviour), to_yaml(documents.scenario));
    INFO("seed " << seed << ": " << result.why);
    REQUIRE(result.compiled);
    several += result.compiled->lowered.view().components.size() > 1 ? 1 : 0;
  }
  CHECK(several > 80);
}

} // namespace
