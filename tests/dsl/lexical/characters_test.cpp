// SPDX-License-Identifier: MIT
#include "dsl/lexical/characters.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;

TEST_CASE("Blanks are trimmed at both ends, and are those that are named") {
  CHECK(trimmed("  a b ") == "a b");
  CHECK(trimmed("   ").empty());
  CHECK(trimmed("").empty());
  CHECK(trimmed("\ta ") == "\ta");
  CHECK(trimmed(" \ta\r", " \t\r") == "a");
}

TEST_CASE("A column is the count of bytes before it in its line") {
  CHECK(column_of("ab\ncd\n", 0) == 0);
  CHECK(column_of("ab\ncd\n", 2) == 2); // the newline itself
  CHECK(column_of("ab\ncd\n", 3) == 0);
  CHECK(column_of("ab\ncd\n", 4) == 1);
}
