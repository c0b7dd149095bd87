// SPDX-License-Identifier: MIT
#include "compiler/base/version.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

TEST_CASE("the version is three numbers with dots between") {
  const std::string_view version = director::compiler::version();
  CHECK(std::ranges::count(version, '.') == 2);
  CHECK(std::ranges::all_of(version, [](char c) { return c == '.' || (c >= '0' && c <= '9'); }));
}
