// SPDX-License-Identifier: MIT
#include "tests/docs/shortened.hpp"

#include <catch2/catch.hpp>

using namespace director::tests;

TEST_CASE("a text that is marked as shortened is unchanged") {
  const Lines whole{"a", "b", "c", "d"};
  for (const Lines& shown : {Lines{"a", "b", "c", "d"}, Lines{"…"}, Lines{"a", "…", "d"}, Lines{"  …", "c", "d", "…"}})
    CHECK(shortened(whole, shown) == shown);
}

TEST_CASE("a text that is shortened without a mark becomes whole") {
  CHECK(shortened({"a", "b", "c", "d"}, {"a", "d"}) == Lines{"a", "b", "c", "d"});
  CHECK(shortened({"a"}, {"a", "d"}) == Lines{"a"});
  CHECK(shortened({"a", "b"}, {}) == Lines{"a", "b"});
  CHECK(shortened({}, {"a"}).empty());
}

TEST_CASE("a line that changed is replaced in its place") {
  const Lines whole{"start", "12 runs", "middle", "4 pushes, 6 steps", "end"};
  CHECK(shortened(whole, {"…", "13 runs", "…", "4 pushes, 7 steps", "…"}) ==
        Lines{"…", "12 runs", "…", "4 pushes, 6 steps", "…"});
}

TEST_CASE("a line that is not there any more disappears among the lines that are left out") {
  CHECK(shortened({"start", "middle", "end"}, {"start", "…", "something else", "…", "end"}) ==
        Lines{"start", "…", "…", "end"});
}

TEST_CASE("lines in the wrong order are put right") { CHECK(shortened({"a", "b"}, {"b", "a"}) == Lines{"a", "b"}); }
