// SPDX-License-Identifier: MIT
#include "tests/layout/source_tree.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace director::tests;

namespace {

constexpr std::size_t first_lines = 3;

bool is_script(const ProjectFile& file) { return !file.lines.empty() && file.lines.front().starts_with("#!"); }

bool is_source(const ProjectFile& file) {
  for (const char* end : {".cpp", ".hpp", ".cmake", ".ts", ".js", ".mjs", ".idl", "CMakeLists.txt"})
    if (file.path.ends_with(end)) return true;
  return is_script(file);
}

/// Projects as users have them, with what a user would write and no more. Beside those of tests/system/cmake lies what
/// runs them.
bool is_a_users(const std::string& path) {
  const std::string cmake = "tests/system/cmake/";
  if (path.starts_with(cmake)) return path.find('/', cmake.size()) != std::string::npos;
  return path.starts_with("tests/system/arm/consumer/") || path.starts_with("tests/runtime/dds/consumer/");
}

/// Generated code names no licence: users choose it (docs/faq.md).
bool is_generated(const std::string& path) { return path.starts_with("generated/"); }

bool names_its_licence(const ProjectFile& file) {
  const std::size_t count = std::min(first_lines, file.lines.size());
  return std::any_of(file.lines.begin(), file.lines.begin() + static_cast<std::ptrdiff_t>(count),
                     [](const std::string& line) { return line.ends_with(" SPDX-License-Identifier: MIT"); });
}

} // namespace

TEST_CASE("each source names its licence in its first lines") {
  for (const ProjectFile& file : project_files())
    if (is_source(file) && !is_a_users(file.path) && !is_generated(file.path) && !names_its_licence(file))
      FAIL_CHECK(file.path << ":1: the licence is missing: SPDX-License-Identifier: MIT");
  SUCCEED();
}

TEST_CASE("a licence counts in the first lines, of all but users' projects") {
  CHECK(names_its_licence({"a.hpp", {"#pragma once", "// SPDX-License-Identifier: MIT"}}));
  CHECK_FALSE(names_its_licence({"a.hpp", {"#pragma once", "", "", "// SPDX-License-Identifier: MIT"}}));
  CHECK_FALSE(names_its_licence({"a.hpp", {}}));
  CHECK(is_source({"tests/x/CMakeLists.txt", {}}));
  CHECK(is_source({"compiler/page/web/page.ts", {}}));
  CHECK(is_source({"start", {"#!/bin/bash"}}));
  CHECK_FALSE(is_source({"docs/page.md", {"# Page"}}));
  CHECK(is_a_users("tests/system/cmake/consumer/main.cpp"));
  CHECK_FALSE(is_a_users("tests/system/cmake/consumer.cmake"));
  CHECK(is_generated("generated/soccer/soccer.hpp"));
}
