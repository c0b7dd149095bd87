// SPDX-License-Identifier: MIT
#include "compiler/stubs/insertion.hpp"

#include <catch2/catch.hpp>

using namespace director::compiler::stubs;

TEST_CASE("lines that are put between others are added lines") {
  CHECK(diff("a.cpp", "1\n2\n3\n4\n5\n6\n7\n8\n9\n", {{"a.cpp", 7, "\nx\ny"}}) ==
        "--- a/a.cpp\n+++ b/a.cpp\n@@ -2,6 +2,8 @@\n 2\n 3\n 4\n+x\n+y\n 5\n 6\n 7\n");
  CHECK(diff("a.cpp", "1\n2\n", {{"a.cpp", 0, "x\n"}, {"a.cpp", 4, "y\n"}}) ==
        "--- a/a.cpp\n+++ b/a.cpp\n@@ -1,2 +1,4 @@\n+x\n 1\n 2\n+y\n");
}

TEST_CASE("places that are far apart are hunks of their own") {
  CHECK(diff("a", "1\n2\n3\n4\n5\n6\n7\n8\n9\n", {{"a", 0, "x\n"}, {"a", 18, "y\n"}}) ==
        "--- a/a\n+++ b/a\n@@ -1,3 +1,4 @@\n+x\n 1\n 2\n 3\n@@ -7,3 +8,4 @@\n 7\n 8\n 9\n+y\n");
}

TEST_CASE("a line that something is put into comes back in several") {
  CHECK(diff("a", "struct A {};\n", {{"a", 10, "\n  int b;\n"}}) ==
        "--- a/a\n+++ b/a\n@@ -1 +1,3 @@\n-struct A {};\n+struct A {\n+  int b;\n+};\n");
}

TEST_CASE("a file without a line break at its end keeps none") {
  CHECK(diff("a", "1\n2", {{"a", 3, "\nx"}}) == "--- a/a\n+++ b/a\n@@ -1,2 +1,3 @@\n 1\n-2\n\\ No newline at end of "
                                                "file\n+2\n+x\n\\ No newline at end of file\n");
}

TEST_CASE("a new file is all added") {
  CHECK(diff_of_new("a/b.cpp", "1\n2\n") == "--- /dev/null\n+++ b/a/b.cpp\n@@ -0,0 +1,2 @@\n+1\n+2\n");
}
