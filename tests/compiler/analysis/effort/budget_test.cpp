// SPDX-License-Identifier: MIT
#include "compiler/analysis/effort/budget.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::analysis;

TEST_CASE("a search is granted what it wants until the budget is spent, and a little ever after") {
  Budget budget(100'000);
  CHECK(budget.grant(60'000) == 60'000);
  budget.spend(60'000);
  CHECK(budget.grant(60'000) == 40'000);
  budget.spend(60'000);
  CHECK(budget.exhausted());
  CHECK(budget.grant(60'000) == Budget::of_any_search);
  CHECK(budget.grant(10) == 10);
}

TEST_CASE("a question that is left open twice counts once") {
  Budget budget;
  budget.leave_open({}, "whether it rains");
  budget.leave_open({}, "whether it snows");
  budget.leave_open({}, "whether it rains");
  REQUIRE(budget.open().size() == 2);
  CHECK(budget.open()[0].words == "whether it rains");
  CHECK(budget.open()[1].words == "whether it snows");
}

} // namespace
