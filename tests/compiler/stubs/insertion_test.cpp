// SPDX-License-Identifier: MIT
#include "compiler/stubs/insertion.hpp"

#include <catch2/catch.hpp>

using namespace director::compiler::stubs;

TEST_CASE("what is inserted can be taken out again") {
  const std::vector<Insertion> two = joined({{"a", 3, "<2>"}, {"a", 0, "<1>"}, {"b", 0, "x"}, {"a", 3, "<3>"}});
  CHECK(two == std::vector<Insertion>{{"a", 0, "<1>"}, {"a", 3, "<2><3>"}, {"b", 0, "x"}});
  REQUIRE(by_file(two).size() == 2);
  const Applied applied = insert_into("abc", by_file(two)[0]);
  CHECK(applied.text == "<1>abc<2><3>");
  CHECK(applied.ranges == std::vector<Range>{{0, 3}, {6, 12}});
  CHECK(without(applied) == "abc");
}

TEST_CASE("a place in the new text is one in the old text, or one where something is inserted") {
  const Applied applied = insert_into("abc", {{"a", 0, "<1>"}, {"a", 2, "<2>"}});
  REQUIRE(applied.text == "<1>ab<2>c");
  const std::vector<Origin> expected{{0, true}, {0, true}, {0, true}, {0, false}, {1, false},
                                     {2, true}, {2, true}, {2, true}, {2, false}, {3, false}};
  for (std::size_t at = 0; at < expected.size(); ++at) CHECK(origin_of(applied, at) == expected[at]);
}

TEST_CASE("a formatter is obeyed only within what was inserted") {
  const std::vector<Insertion> one{{"a", 3, "\n int  b ;"}};
  const Applied applied = insert_into("ab;  c", one);
  REQUIRE(applied.text == "ab;\n int  b ;  c");
  const std::vector<Replacement> replacements{
      {0, 0, "// the user's\n"}, // before it
      {3, 2, "\n  "},            // the indentation
      {8, 2, " "},               // between the words
      {11, 1, ""},               // before the semicolon
      {13, 2, " "},              // behind it
      {12, 3, " "},              // across its end
      {13, 0, "\n"},             // at its end
      {3, 0, "\n"},              // at its beginning
  };
  const std::vector<Insertion> better = formatted(one, applied, replacements);
  CHECK(better == std::vector<Insertion>{{"a", 3, "\n  int b;"}});
  CHECK(without(insert_into("ab;  c", better)) == "ab;  c");
}
