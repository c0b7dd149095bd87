// SPDX-License-Identifier: MIT
// Tests dsl/data.hpp.
#include "dsl/data.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;

namespace {

Data scalar(Data::Kind kind, const char* text) { return {kind, text, {}, {}}; }
Data number(const char* text) { return scalar(Data::Kind::integer, text); }

} // namespace

TEST_CASE("Data is printed in flow style") {
  const Data list{Data::Kind::list, "", {}, {number("1"), scalar(Data::Kind::text, "left")}};
  const Data mapping{Data::Kind::mapping, "", {"at", "sure"}, {list, scalar(Data::Kind::boolean, "true")}};
  CHECK(to_text(mapping) == "{at: [1, left], sure: true}");
  CHECK(to_text(Data{Data::Kind::list, "", {}, {}}) == "[]");
  CHECK(to_text(Data{Data::Kind::mapping, "", {}, {}}) == "{}");
}

TEST_CASE("A text that would be read as something else is printed in quotes") {
  for (const char* text : {"3", "-3", "0x1F", "1.5", "1e3", "true", "false", "null", "~", ""}) {
    CAPTURE(text);
    CHECK(to_text(scalar(Data::Kind::text, text)) == "'" + std::string(text) + "'");
  }
  for (const char* text : {"[a]", "x: y", "a, b", " a", "a ", "a #b", "- a", "-", "a:", "{", "#a", "&a", "\"a\""}) {
    CAPTURE(text);
    CHECK(to_text(scalar(Data::Kind::text, text)) == "'" + std::string(text) + "'");
  }
  CHECK(to_text(scalar(Data::Kind::text, "'a'")) == "'''a'''");
  for (const char* text : {"left", "2024-01-01", "3 s", "True", "0x", "a-b", "a:b", "a#b", "it's"}) {
    CAPTURE(text);
    CHECK(to_text(scalar(Data::Kind::text, text)) == text);
  }
  CHECK(to_text(number("3")) == "3");
}

TEST_CASE("A text with a line break, or another control character, is printed with escapes") {
  CHECK(to_text(scalar(Data::Kind::text, "x\ny")) == "\"x\\ny\"");
  CHECK(to_text(scalar(Data::Kind::text, "a\tb\x01")) == "\"a\\tb\\x01\"");
}

TEST_CASE("The order of a mapping does not count, that of a list does") {
  const Data one = number("1"), two = number("2");
  CHECK(Data{Data::Kind::mapping, "", {"a", "b"}, {one, two}} == Data{Data::Kind::mapping, "", {"b", "a"}, {two, one}});
  CHECK_FALSE(Data{Data::Kind::mapping, "", {"a", "b"}, {one, two}} ==
              Data{Data::Kind::mapping, "", {"a", "c"}, {one, two}});
  CHECK_FALSE(Data{Data::Kind::list, "", {}, {one, two}} == Data{Data::Kind::list, "", {}, {two, one}});
}

TEST_CASE("A number is not the text of its digits") { CHECK_FALSE(number("3") == scalar(Data::Kind::text, "3")); }
