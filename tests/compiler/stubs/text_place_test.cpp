// SPDX-License-Identifier: MIT
#include "compiler/stubs/text_place.hpp"

#include <catch2/catch.hpp>

#include <string>

using namespace director::compiler::stubs;

namespace {

/// Where `behind` is, as `|` in the text, when something ends at the first `^`.
std::string mark(std::string text) {
  const std::size_t end = text.find('^');
  text.erase(end, 1);
  return text.insert(behind(text, end), "|");
}

} // namespace

TEST_CASE("a comment behind a function on its line belongs to it") {
  CHECK(mark("f();^\ng();") == "f();|\ng();");
  CHECK(mark("f();^ // why\ng();") == "f(); // why|\ng();");
  CHECK(mark("f();^ /* a */ /* b */\t\r\ng();") == "f(); /* a */ /* b */\t|\r\ng();");
  CHECK(mark("f();^ // last") == "f(); // last|");
  CHECK(mark("f();^") == "f();|");
}

TEST_CASE("what follows on the same line stays behind") {
  CHECK(mark("f();^ g();\n") == "f();| g();\n");
  CHECK(mark("f();^ };\n") == "f();| };\n");
  CHECK(mark("f();^ /* goes\non */ g();") == "f();| /* goes\non */ g();");
  CHECK(mark("f();^ // goes \\\non\n") == "f();| // goes \\\non\n");
  CHECK(mark("f();^ // goes \\ \t\r\non\n") == "f();| // goes \\ \t\r\non\n");
}

TEST_CASE("line breaks and indentation are the file's own") {
  CHECK(line_break("a\r\nb\n") == "\r\n");
  CHECK(line_break("a\nb\r\n") == "\n");
  CHECK(line_break("a") == "\n");
  CHECK(indentation("x\n\t  y", 5) == "\t  ");
  CHECK(indentation("\xEF\xBB\xBF  y", 5) == "  ");
  CHECK(before("x {\n  }", 6) == 4);
  CHECK(before("x { }", 4) == 4);
}

TEST_CASE("a line and a column are an offset, and an offset has a line") {
  const std::string_view text = "ab\r\nc\n";
  CHECK(offset_at(text, 1, 2) == 1);
  CHECK(offset_at(text, 2, 1) == 4);
  CHECK(offset_at(text, 2, 9) == 6);
  CHECK(offset_at(text, 4, 1) == 6);
  CHECK(line_of(text, 3) == 1);
  CHECK(line_of(text, 4) == 2);
  CHECK(line_of(text, 6) == 3);
}
