// SPDX-License-Identifier: MIT
// Not a test of the project: a program for tests/system/bless/bless.cmake to run.
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

TEST_CASE("one golden", "[golden]") { director::tests::check_golden("one.txt", "first\nsecond\n"); }

TEST_CASE("a folder of goldens", "[golden]") {
  director::tests::check_golden_folder("folder", {{"a.txt", "a\n"}, {"deep/b.txt", "b\n"}});
}
