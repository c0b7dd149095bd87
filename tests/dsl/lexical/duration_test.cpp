// SPDX-License-Identifier: MIT
// Tests dsl/lexical/duration.hpp.
#include "dsl/lexical/duration.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;

TEST_CASE("A duration is a whole number and a unit") {
  struct Row {
    const char* text;
    std::int64_t microseconds;
    const char* normal;
  };
  for (const Row& row : {Row{"500 ms", 500'000, "500 ms"}, Row{"2s", 2'000'000, "2 s"}, Row{" 10  us ", 10, "10 us"},
                         Row{"1 min", 60'000'000, "1 min"}, Row{"0 s", 0, "0 s"},
                         Row{"9999999999 min", 599'999'999'940'000'000, "9999999999 min"},
                         Row{"999999999999999999us", 999'999'999'999'999'999, "999999999999999999 us"}}) {
    CAPTURE(row.text);
    const auto duration = parse_duration(row.text);
    REQUIRE(duration);
    CHECK(duration->microseconds() == row.microseconds);
    CHECK(to_text(*duration) == row.normal);
  }
}

TEST_CASE("What is not a duration is none") {
  for (const char* text : {"", "ms", "10", "1.5 s", "-1 s", "10 h", "10 MS", "007 s", "1 s s", "1 000 ms", "+1 s",
                           "10000000000 min", "9223372036854775808 us"}) {
    CAPTURE(text);
    CHECK_FALSE(parse_duration(text));
  }
}

TEST_CASE("What is too long for a duration is distinguished from what is none, with the longest in its unit") {
  struct Row {
    const char* text;
    const char* most;
  };
  for (const Row& row :
       {Row{"1000000000000000000 us", "999999999999999999 us"}, Row{"1000000000000000ms", "999999999999999 ms"},
        Row{" 1000000000000 s ", "999999999999 s"}, Row{"10000000000 min", "9999999999 min"},
        Row{"99999999999999999999999999999999 s", "999999999999 s"}}) {
    CAPTURE(row.text);
    CHECK_FALSE(parse_duration(row.text));
    const auto most = most_instead_of(row.text);
    REQUIRE(most);
    CHECK(to_text(*most) == row.most);
    REQUIRE(parse_duration(row.most));
    CHECK(parse_duration(row.most)->microseconds() < longest_duration);
  }
  for (const char* text : {"", "10 ms", "0 s", "1.5 s", "99999999999999999999 h", "099999999999999 s"}) {
    CAPTURE(text);
    CHECK_FALSE(most_instead_of(text));
  }
}

TEST_CASE("a time is printed in the largest unit, up to seconds, that leaves no rest") {
  CHECK(to_text(in_largest_unit(0)) == "0 s");
  CHECK(to_text(in_largest_unit(120'000'000)) == "120 s");
  CHECK(to_text(in_largest_unit(1'500'000)) == "1500 ms");
  CHECK(to_text(in_largest_unit(1'000'001)) == "1000001 us");
}
