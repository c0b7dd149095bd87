// SPDX-License-Identifier: MIT
// Tests compiler/base/seconds.hpp and counted.hpp: numbers in messages.
#include "compiler/base/counted.hpp"
#include "compiler/base/seconds.hpp"

#include <catch2/catch.hpp>

using namespace director::compiler;

TEST_CASE("a duration has no superfluous digits") {
  CHECK(as_duration(0) == "0 s");
  CHECK(as_duration(250) == "250 us");
  CHECK(as_duration(1'000) == "0.001 s");
  CHECK(as_duration(1'500'000) == "1.5 s");
  CHECK(as_duration(10'000'000) == "10 s");
  CHECK(as_duration(59'999'600) == "1 min 0 s");
  CHECK(as_duration(3'599'990'000) == "59 min 59.99 s");
  CHECK(as_duration(3'599'999'900) == "1 h 0 min 0 s");
  CHECK(as_duration(90'061'000'000) == "25 h 1 min 1 s");
}

TEST_CASE("a large count has separators") {
  CHECK(many_counted(0, "event") == "0 events");
  CHECK(many_counted(1, "event") == "1 event");
  CHECK(many_counted(999, "push") == "999 pushes");
  CHECK(many_counted(1'000, "event") == "1,000 events");
  CHECK(many_counted(1'587'146, "event") == "1,587,146 events");
}
