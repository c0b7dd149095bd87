// SPDX-License-Identifier: MIT
#include "tests/property/compiled.hpp"
#include "tests/property/shrink.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director::property;

TEST_CASE("a failing case is reduced to the cause of its failure, and can still be run") {
  const auto fails = [](const Documents& documents) {
    const CompileResult result = compile(to_yaml(documents.behaviour), to_yaml(documents.scenario));
    if (!result.compiled) return false;
    const auto& edges = result.compiled->model.edges;
    const auto optional = [](const auto& level) { return level.optional; };
    return std::any_of(edges.begin(), edges.end(), [&](const auto& edge) {
      return edge.requester && std::any_of(edge.levels.begin(), edge.levels.end(), optional);
    });
  };
  Documents documents;
  std::uint64_t seed = 1;
  do documents = generate(seed++);
  while (!fails(documents));
  const Documents small = shrink(documents, fails);
  REQUIRE(fails(small));
  const CompileResult result = compile(to_yaml(small.behaviour), to_yaml(small.scenario));
  CHECK(result.compiled->model.groups.size() == 2);
  CHECK(result.compiled->model.states.size() == 0);
  CHECK(result.compiled->spec.steps.empty());
}

} // namespace
