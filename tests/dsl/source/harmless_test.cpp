// SPDX-License-Identifier: MIT
// Tests dsl/source/harmless.hpp.
#include "dsl/source/harmless.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;

TEST_CASE("What commands a terminal is spelled out, and letters stay as they are") {
  CHECK(harmless("Kick, \u00E9, \u20AC and \u2026") == "Kick, \u00E9, \u20AC and \u2026");
  CHECK(harmless("a\x1B[31mb\r\n\tc\x7F") == "a\\x1B[31mb\\x0D\\x0A\\x09c\\x7F");
  CHECK(harmless("a\u009B31mb") == "a\\x9B31mb");
  CHECK(harmless(std::string_view("a\0b", 3)) == "a\\x00b");
}

TEST_CASE("What turns the direction of a text is spelled out") {
  CHECK(harmless("a\u202Eb\u2066c\u200Fd\u200Ee") == "a\\u202Eb\\u2066c\\u200Fd\\u200Ee");
  CHECK(harmless("a\xE2\x80") == "a\xE2\x80"); // cut off
}

TEST_CASE("Lines stay lines where they are to") { CHECK(harmless_lines("a\x1B\nb\r\n") == "a\\x1B\nb\\x0D\n"); }

TEST_CASE("Tabs of code stay tabs") { CHECK(harmless_code("\ta\x1B\nb\r\n") == "\ta\\x1B\nb\\x0D\n"); }
