// SPDX-License-Identifier: MIT
// Tests compiler/base/hunks.hpp.
#include "compiler/base/hunks.hpp"

#include <catch2/catch.hpp>

using namespace director::compiler;

namespace {

using Lines = std::vector<std::string>;

/// As many equal lines.
std::vector<DiffLine> equal(std::size_t count) { return std::vector<DiffLine>(count, {' ', "same"}); }

std::vector<DiffLine> joined(std::initializer_list<std::vector<DiffLine>> parts) {
  std::vector<DiffLine> out;
  for (const std::vector<DiffLine>& part : parts) out.insert(out.end(), part.begin(), part.end());
  return out;
}

} // namespace

TEST_CASE("equal files have no hunk") { CHECK(hunks(equal(9)).empty()); }

TEST_CASE("a hunk has three lines around what differs, and one line is counted without its number of lines") {
  CHECK(hunks(joined({equal(5), {{'-', "old"}, {'+', "new"}}, equal(5)})) ==
        Lines{"@@ -3,7 +3,7 @@", " same", " same", " same", "-old", "+new", " same", " same", " same"});
  CHECK(hunks({{'-', "old"}, {'+', "new"}}) == Lines{"@@ -1 +1 @@", "-old", "+new"});
}

TEST_CASE("a side without lines names the line before") {
  CHECK(hunks({{'+', "first"}, {'+', "second"}}) == Lines{"@@ -0,0 +1,2 @@", "+first", "+second"});
  CHECK(hunks({{'-', "only"}}) == Lines{"@@ -1 +0,0 @@", "-only"});
}

TEST_CASE("differences with up to six lines between them are one hunk, others are two") {
  const std::vector<DiffLine> change{{'+', "new"}};
  CHECK(hunks(joined({change, equal(6), change})).front() == "@@ -1,6 +1,8 @@");
  const Lines two = hunks(joined({change, equal(7), change}));
  CHECK(two == Lines{"@@ -1,3 +1,4 @@", "+new", " same", " same", " same", "@@ -5,3 +6,4 @@", " same", " same", " same",
                     "+new"});
}
