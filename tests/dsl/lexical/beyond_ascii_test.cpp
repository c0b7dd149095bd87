// SPDX-License-Identifier: MIT
// Tests dsl/lexical/beyond_ascii.hpp.
#include "dsl/lexical/beyond_ascii.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;

TEST_CASE("the first character beyond ASCII is named by its number") {
  CHECK(first_beyond_ascii("").empty());
  CHECK(first_beyond_ascii("Walk_2 ~\x7F").empty());
  CHECK(first_beyond_ascii("a\xC2\xA0\xD0\x90") == "U+00A0");
  CHECK(first_beyond_ascii("\xD0\x90") == "U+0410");
  CHECK(first_beyond_ascii("A\xE2\x80\x8B") == "U+200B");
  CHECK(first_beyond_ascii("A\xEF\xBB\xBF") == "U+FEFF");
  CHECK(first_beyond_ascii("\xF0\x9F\xA4\x96") == "U+1F916");
  CHECK(first_beyond_ascii("A\x80") == "\\x80");
}

TEST_CASE("what looks like a blank or a colon is named with what to write") {
  CHECK(help_for_look_alike("10 ms: \xD0\x90").empty());
  CHECK(help_for_look_alike("10\xC2\xA0ms") == "it has no-break spaces in it: write blanks in their place");
  CHECK(help_for_look_alike("A\xEF\xBC\x9A{}") == "it has a full-width colon in it: write `: `");
}
