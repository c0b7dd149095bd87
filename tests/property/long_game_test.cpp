// SPDX-License-Identifier: MIT
// Incremental passes decide the same as passes that decide everything again.
//
//   DIRECTOR_SEED   first seed, instead of 1
//   DIRECTOR_CASES  how many games, instead of as many as take some seconds
#include "tests/property/generate.hpp"
#include "tests/property/long_game.hpp"
#include "tests/property/watch.hpp"
#include "tests/support/environment.hpp"

#include <catch2/catch.hpp>

#include <iostream>

namespace {

using namespace director::property;
using director::tests::from_environment;

TEST_CASE("in long games an incremental pass decides the same as a pass from nothing") {
  const auto first = from_environment<std::uint64_t>("DIRECTOR_SEED", 1);
  const std::uint64_t games = director::tests::cases_of({.usual = 600, .slow = 20});
  std::uint64_t micro_steps = 0;
  for (std::uint64_t seed = first; seed < first + games; ++seed) {
    watch(seed);
    const Documents documents = generate_any(seed);
    const CompileResult result = compile(to_yaml(documents.behaviour), to_yaml(documents.scenario));
    if (!result.compiled) FAIL("DIRECTOR_SEED=" << seed << " is not valid: " << result.why);
    const std::string wrong = decided_otherwise(*result.compiled, seed, micro_steps);
    stop_watching();
    if (!wrong.empty()) FAIL("DIRECTOR_SEED=" << seed << " differs " << wrong << to_yaml(documents.behaviour));
  }
  std::cout << games << " games from seed " << first << ", " << micro_steps << " micro-steps\n";
  CHECK(micro_steps > games * 100);
}

} // namespace
