// SPDX-License-Identifier: MIT
#include "compiler/base/html.hpp"

#include <catch2/catch.hpp>

using namespace director::compiler;

TEST_CASE("what XML cannot hold is a blank") {
  CHECK(html(std::string_view("a\0b\x1B[31m \x7F", 10)) == "a b [31m \x7F");
  CHECK(html("one\ttwo\r\nthree \xEF\xBF\xBE \xEF\xBF\xBD.") == "one\ttwo\r\nthree   \xEF\xBF\xBD.");
  CHECK(html("l\xE4t, \xE2\x82 and \xF0\x9F\x90\xA2 \xE2") == "l\uFFFDt, \uFFFD\uFFFD and \xF0\x9F\x90\xA2 \uFFFD");
  CHECK(html_attribute("<\"&\n\x01>") == "&lt;&quot;&amp;&#10; &gt;");
}
