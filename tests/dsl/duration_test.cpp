// Tests dsl/duration.hpp.
#include "dsl/duration.hpp"

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
                         Row{"153722867280 min", 9'223'372'036'800'000'000, "153722867280 min"}}) {
    CAPTURE(row.text);
    const auto duration = parse_duration(row.text);
    REQUIRE(duration);
    CHECK(duration->microseconds() == row.microseconds);
    CHECK(to_text(*duration) == row.normal);
  }
}

TEST_CASE("What is not a duration is none") {
  for (const char* text : {"", "ms", "10", "1.5 s", "-1 s", "10 h", "10 MS", "007 s", "1 s s", "1 000 ms", "+1 s",
                           "153722867281 min", "9223372036854775808 us"}) {
    CAPTURE(text);
    CHECK_FALSE(parse_duration(text));
  }
}
