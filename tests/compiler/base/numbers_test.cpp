// SPDX-License-Identifier: MIT
// Tests compiler/base/seconds.hpp and counted.hpp: numbers in messages.
#include "compiler/base/counted.hpp"
#include "compiler/base/seconds.hpp"

#include <catch2/catch.hpp>

#include <limits>

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
  CHECK(as_duration(std::numeric_limits<std::uint64_t>::max()) == "5124095576 h 1 min 49.552 s");
}

TEST_CASE("a time has six digits after the point, exactly, also where a floating-point number has not so many") {
  CHECK(in_seconds(0) == "0.000000");
  CHECK(in_seconds(1'500'000) == "1.500000");
  CHECK(in_seconds(-1) == "-0.000001");
  CHECK(in_seconds(9'223'372'036'854'747'905) == "9223372036854.747905");
  CHECK(in_seconds(std::numeric_limits<std::int64_t>::min()) == "-9223372036854.775808");
}

TEST_CASE("a large count has separators") {
  CHECK(many_counted(0, "event") == "0 events");
  CHECK(many_counted(1, "event") == "1 event");
  CHECK(many_counted(999, "push") == "999 pushes");
  CHECK(many_counted(1'000, "event") == "1,000 events");
  CHECK(many_counted(1'587'146, "event") == "1,587,146 events");
}
