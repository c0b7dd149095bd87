// SPDX-License-Identifier: MIT
#include "compiler/play/expect/line_diff.hpp"

#include <catch2/catch.hpp>

using director::compiler::unified_diff;
using Lines = std::vector<std::string>;

TEST_CASE("equal lists differ in nothing") {
  CHECK(unified_diff({}, {}).empty());
  CHECK(unified_diff({"a", "b"}, {"a", "b"}).empty());
}

TEST_CASE("a line that is another one") {
  CHECK(unified_diff({"a", "b", "c"}, {"a", "x", "c"}) ==
        Lines{"--- expected", "+++ happened", "@@ -1,3 +1,3 @@", " a", "-b", "+x", " c"});
}

TEST_CASE("lines where none were expected, and none where some were") {
  CHECK(unified_diff({}, {"a", "b"}) == Lines{"--- expected", "+++ happened", "@@ -0,0 +1,2 @@", "+a", "+b"});
  CHECK(unified_diff({"a"}, {}) == Lines{"--- expected", "+++ happened", "@@ -1 +0,0 @@", "-a"});
}

TEST_CASE("of equal lines one is gone, or one more comes") {
  CHECK(unified_diff({"a", "a"}, {"a"}) == Lines{"--- expected", "+++ happened", "@@ -1,2 +1 @@", " a", "-a"});
  CHECK(unified_diff({"a"}, {"a", "a"}) == Lines{"--- expected", "+++ happened", "@@ -1 +1,2 @@", " a", "+a"});
}

TEST_CASE("a line moves") {
  CHECK(unified_diff({"stop", "run A", "run B"}, {"run A", "run B", "stop"}) ==
        Lines{"--- expected", "+++ happened", "@@ -1,3 +1,3 @@", "-stop", " run A", " run B", "+stop"});
}

TEST_CASE("distant differences are in hunks of their own") {
  const Lines expected{"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"};
  Lines happened = expected;
  happened.front() = "zero";
  happened.back() = "nine";
  CHECK(unified_diff(expected, happened) == Lines{"--- expected", "+++ happened", "@@ -1,4 +1,4 @@", "-0", "+zero",
                                                  " 1", " 2", " 3", "@@ -7,4 +7,4 @@", " 6", " 7", " 8", "-9",
                                                  "+nine"});
}

TEST_CASE("a long difference is cut and has the number of the rest") {
  const Lines happened(100, "run A");
  const Lines diff = unified_diff({}, happened, 5);
  CHECK(diff ==
        Lines{"--- expected", "+++ happened", "@@ -0,0 +1,100 @@", "+run A", "+run A", "... and 98 more lines"});
}

TEST_CASE("lists too long to compare line by line differ in all between their equal ends") {
  Lines expected{"first"}, happened{"first"};
  for (int i = 0; i < 3000; ++i) {
    expected.push_back("e" + std::to_string(i));
    happened.push_back("h" + std::to_string(i));
  }
  const Lines diff = unified_diff(expected, happened, 6000);
  CHECK(diff[2] == "@@ -1,3001 +1,3001 @@");
  CHECK(diff[3] == " first");
  CHECK(diff[4] == "-e0");
  CHECK(diff[3004] == "+h0");
}
