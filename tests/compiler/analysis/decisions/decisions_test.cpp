// SPDX-License-Identifier: MIT
// What is decided, and that it is true: tests/property/decisions_test.cpp. Here how much is looked at.
#include "compiler/analysis/decisions/decisions.hpp"

#include <catch2/catch.hpp>

namespace {

using director::analysis::Decisions;

TEST_CASE("a file of one group more has hardly fewer steps to decide in, and one of very many has some") {
  CHECK(Decisions::steps_for(1) == Decisions::most_steps);
  CHECK(Decisions::steps_for(100) == Decisions::most_steps);
  for (std::size_t groups = 1; groups < 3'000; ++groups) {
    const auto here = Decisions::steps_for(groups), next = Decisions::steps_for(groups + 1);
    if (next > here || next * 100 < here * 99) FAIL("from " << groups << " groups on: " << here << ", then " << next);
  }
  CHECK(Decisions::steps_for(10'000) == Decisions::most_steps / 18);
}

} // namespace
