// SPDX-License-Identifier: MIT
#include "tests/bench/random_behaviour.hpp"
#include "tests/bench/table_robot.hpp"
#include "tests/bench/workload.hpp"

#include <catch2/catch.hpp>

using namespace bench;

TEST_CASE("a random behaviour is the same for one seed, has one component, and has the stated number of groups") {
  for (const std::size_t groups : {20U, 60U, 200U}) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const std::string text = random_behaviour(groups, seed);
      INFO(text);
      CHECK(text == random_behaviour(groups, seed));
      CHECK(text != random_behaviour(groups, seed + 1));
      const Compiled compiled = compile_text(text);
      CHECK(compiled.model.groups.size() == groups);
      CHECK(compiled.lowered.view().components.size() == 1);
    }
  }
}

TEST_CASE("each workload plays the same when it is repeated, comes to rest, and calls providers") {
  for (const Workload& each : workloads()) {
    if (each.size > 100 || each.counted == 0) continue;
    INFO(each.name);
    const std::size_t inputs = 300;
    const Tape first = record(each, 1, inputs), again = record(each, 1, inputs);
    CHECK(first.inputs() == inputs);
    CHECK(first.calls() > (each.name == "wide" ? inputs / 4 : inputs)); // all units of that one fail
    CHECK(first.calls() == again.calls());
  }
}
